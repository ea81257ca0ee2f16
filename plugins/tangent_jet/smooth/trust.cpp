// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/trust.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace geodrome {
namespace {

// Measured on 14 shapes of 2,000 to 8,000 points: six smooth ones, clean and with noise of 0.01 to 1 % of the diagonal,
// three with a boundary, cubes, thin plates, creases of 17 to 62 degrees, a machine part. README.md has the figures.

/// Residual as a share of the neighbourhood's radius. Where the points of a cube show its edges, a face over an edge
/// has a corner or a neighbour of one above 0.028. A smooth shape goes as high only where 32 points reach half around
/// it; below this bound the blend is ten times nearer to it than the faces are.
constexpr double roughest = 0.025;
/// Residual as a share of the height to which the quartic's curvature takes it at its radius: what a quartic leaves out
/// of a shape that it shows is small against that, but not of a crease, however blunt. Of smooth shapes of 8,000 points
/// it is 1e-6 to 5e-4, in the tightest bends of genus 2 and 5 up to 0.016; within an edge of creases of 10 to 60
/// degrees 0.004 to 0.4, and above 0.008 in two of three places. Without this bound distances over creases of 30 and 45
/// degrees with points on them were up to 1.2 times as far off as those on the faces.
constexpr double kinked = 0.008;
/// Roughness below this harms nobody, however flat the quartic is.
constexpr double smooth_enough = 1e-6;
/// Residuals up to so many sigma are noise.
constexpr double noise_bound = 1.25;
/// Deviation as a share of the height of the surface above the face. Flat faces near an edge are above it, and most of
/// those at a crease whose points lie on it, where faces are right and the blend is not: at creases of 17 to 62 degrees
/// mean errors of distances were 0.83 to 1.03 times those of the faces; with 0.5 up to 1.7 times.
constexpr double earned = 0.2;
/// A deviation below this share of the longest edge does no harm, whatever the height.
constexpr double negligible = 1e-4;
/// Cosine of the angle between the face and its corners' tangent planes, and sine of that between two corners' surfaces
/// above an edge: beyond them the blend may fold, and lifts are no measure of its distance.
constexpr double steepest = 0.5, most_turned = 0.5;

/// Barycentric coordinates of the places of a face that are looked at.
constexpr std::array<std::array<double, 3>, 4> looked_at{
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};

/// What the residual has beyond noise, as a share of the radius; infinite without a quartic.
double roughness(const QuarticFit& jet, double sigma) {
  if (!jet.determined) return infinity;
  const double noise = noise_bound * sigma;
  return std::sqrt(std::max(0.0, jet.residual * jet.residual - noise * noise)) / jet.radius;
}

/// The largest curvature of a quartic at its base, if it is curved alike in all directions; else somewhat more.
double bend(const QuarticFit& jet) {
  const auto& c = jet.quartic.c;
  return std::sqrt(4 * c[3] * c[3] + 2 * c[4] * c[4] + 4 * c[5] * c[5]);
}

/// Whether a quartic has seen a crease.
bool is_kinked(const QuarticFit& jet, double sigma) {
  return roughness(jet, sigma) > std::max(kinked * bend(jet) * jet.radius, smooth_enough);
}

/// The largest roughness of each vertex and its neighbours: a quartic that sees little of an edge looks smooth, but not
/// those around it.
std::vector<double> roughness_around(const SurfaceMesh& mesh, std::span<const QuarticFit> jets, double sigma) {
  std::vector<double> around(jets.size(), 0);
  for (const Triangle& t : mesh.triangles()) {
    double largest = 0;
    for (const Index v : t) largest = std::max(largest, roughness(jets[v], sigma));
    for (const Index v : t) around[v] = std::max(around[v], largest);
  }
  return around;
}

/// A face with the quartics of its corners.
struct Patch {
  std::array<Vec3, 3> corner;
  std::array<const QuarticFit*, 3> jet;
  NoiseLeft noise;

  double longest_edge() const {
    return std::max({distance(corner[0], corner[1]), distance(corner[1], corner[2]), distance(corner[2], corner[0])});
  }
  bool is_steep() const {
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    return !std::ranges::all_of(
        jet, [&](const QuarticFit* j) { return std::abs(dot(j->quartic.n, normal)) > steepest * norm(normal); });
  }
  /// Height of the most curved of the quartics above a chord of this length, if it is curved alike in all directions.
  double sagitta(double chord) const {
    return std::max({bend(*jet[0]), bend(*jet[1]), bend(*jet[2])}) * chord * chord / 8;
  }
  double deviation(const std::array<double, 3>& b) const;
};

/// The estimate at a place: what the residuals let expect of the blend, or what the corners' surfaces disagree by, if
/// that is more: where the sample is uneven, residuals say little of the sparse side. Infinite beyond the points that a
/// quartic was fitted to, and if the corners' surfaces are turned against each other.
double Patch::deviation(const std::array<double, 3>& b) const {
  const Vec3 point = b[0] * corner[0] + b[1] * corner[1] + b[2] * corner[2];
  double expected = 0, apart = 0, weights = 0;
  std::array<Vec3, 3> lifted, normal;
  for (int i = 0; i < 3; ++i) {
    if (b[i] == 0) continue;
    const Quartic& q = jet[i]->quartic;
    if (distance(point, q.base) > jet[i]->radius) return infinity;
    const double x = dot(point - q.base, q.u), y = dot(point - q.base, q.v), weight = b[i] * b[i];
    // Points that noise moves along normals come nearer to each other on the inner side, which draws the fit there.
    const double drawn = noise.sigma * noise.sigma * bend(*jet[i]);
    expected += weight * (jet[i]->residual * jet[i]->leverage(x, y) + noise.left_out + drawn), weights += weight;
    const Height h = q.at(x, y);
    lifted[i] = q.base + x * q.u + y * q.v + h.z * q.n;
    const Vec3 up = q.n - h.x * q.u - h.y * q.v;
    normal[i] = up / norm(up);
    for (int k = 0; k < i; ++k) {
      if (b[k] == 0) continue;
      if (!(norm(cross(normal[i], normal[k])) < most_turned)) return infinity;
      apart = std::max(apart, std::abs(jet[k]->quartic.above(lifted[i])));
    }
  }
  return std::max(expected / weights, apart);
}

}  // namespace

std::vector<double> face_deviations(const SurfaceMesh& mesh, std::span<const QuarticFit> jets, const NoiseLeft& noise) {
  const double sigma = noise.sigma;
  const std::vector<double> rough = roughness_around(mesh, jets, sigma);
  std::vector<double> deviations(mesh.face_count(), infinity);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangles()[f];
    const Patch patch{mesh.corners(f), {&jets[t[0]], &jets[t[1]], &jets[t[2]]}, noise};
    if (std::max({rough[t[0]], rough[t[1]], rough[t[2]]}) > roughest || patch.is_steep()) continue;
    if (std::ranges::any_of(patch.jet, [&](const QuarticFit* jet) { return is_kinked(*jet, sigma); })) continue;
    double largest = 0;
    for (const auto& place : looked_at) largest = std::max(largest, patch.deviation(place));
    const double edge = patch.longest_edge();
    // With noise the vertices themselves are off by as much, so a face is no better than the blend.
    if (sigma == 0 && largest > std::max(earned * patch.sagitta(edge), negligible * edge)) continue;
    deviations[f] = largest;
  }
  return deviations;
}

}  // namespace geodrome
