// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/sheet_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace geodrome {
namespace {

/// Cosine of the angle between a face and a tangent plane, sine of that between an edge and one. A sheet bends by less
/// from corner to corner; two turns of a spiral are joined at 60 degrees and more.
constexpr double least_cosine = 0.5, most_sine = 0.77;

/// Circumradius and edges over psi, as Lemmas 8 and 9 bound them.
constexpr double most_radius = 2.056, most_edge = 4.112;

/// The largest empty ball that a uniform sample of a sheet has beside its rim is about as large. A slit of four
/// spacings has larger ones (phi's lower quartile is 0.7 to 0.9 spacings).
constexpr double empty_spacings = 1.8;
/// Flat triangles along a rim have large circumradii too, but only one long edge.
constexpr double long_spacings = 4;

Vec3 circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, normal = cross(ab, ac);
  return a + (squared_norm(ab) * cross(ac, normal) + squared_norm(ac) * cross(normal, ab)) / (2 * squared_norm(normal));
}

/// The lengths of the edges, ascending.
std::array<double, 3> edges_of(const Triangle& triangle, const std::vector<Vec3>& points) {
  const Vec3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  std::array<double, 3> edges{distance(a, b), distance(b, c), distance(c, a)};
  std::ranges::sort(edges);
  return edges;
}

}  // namespace

SheetRule::SheetRule(const SheetSample& sample) : sample_(sample), rank_(sample.kept.points.size()) {
  const std::vector<Vec3>& points = sample.kept.points;
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&](Index p) { return std::tuple(points[p].x, points[p].y, points[p].z); });
  for (Index i = 0; i < order.size(); ++i) rank_[order[i]] = i;
}

Triangle SheetRule::in_order(const Triangle& triangle) const {
  Triangle result = triangle;
  std::ranges::sort(result, {}, [&](Index p) { return rank_[p]; });
  return result;
}

bool SheetRule::before(const Triangle& a, const Triangle& b) const {
  return std::ranges::lexicographical_compare(
      a, b, {}, [&](Index p) { return rank_[p]; }, [&](Index p) { return rank_[p]; });
}

double SheetRule::radius(const Triangle& triangle) const {
  const std::vector<Vec3>& points = sample_.kept.points;
  const Vec3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * norm(cross(b - a, c - a)));
}

bool SheetRule::lies_flat(const Triangle& triangle) const {
  const KeptPoints& kept = sample_.kept;
  const Vec3 normal =
      cross(kept.points[triangle[1]] - kept.points[triangle[0]], kept.points[triangle[2]] - kept.points[triangle[0]]);
  for (const Index at : triangle) {
    if (!(std::abs(dot(normal, kept.normals[at])) >= least_cosine * norm(normal))) return false;
    for (const Index to : triangle) {
      const Vec3 edge = kept.points[to] - kept.points[at];
      if (std::abs(dot(edge, kept.normals[at])) > most_sine * norm(edge)) return false;
    }
  }
  return true;
}

bool SheetRule::allows(const Triangle& triangle) const {
  return explained_by_psi(triangle) && lies_flat(triangle) && !spans_a_hole(triangle);
}

/// The spacing of those two points that are on a boundary, if so many are; else 0.
double SheetRule::spacing_at(const Triangle& triangle) const {
  double spacing = std::numeric_limits<double>::infinity();
  int on_boundary = 0;
  for (const Index p : triangle)
    if (sample_.spacing[p] > 0) ++on_boundary, spacing = std::min(spacing, sample_.spacing[p]);
  return on_boundary < 2 ? 0 : spacing;
}

bool SheetRule::explained_by_psi(const Triangle& triangle) const {
  double psi = std::numeric_limits<double>::infinity();
  for (const Index p : triangle) psi = std::min(psi, sample_.kept.psi[p]);
  return edges_of(triangle, sample_.kept.points)[2] <= most_edge * psi && radius(triangle) <= most_radius * psi;
}

bool SheetRule::spans_a_hole(const Triangle& triangle) const {
  const double spacing = spacing_at(triangle);
  if (!(spacing > 0) || edges_of(triangle, sample_.kept.points)[1] <= long_spacings * spacing) return false;
  const std::vector<Vec3>& points = sample_.kept.points;
  const Vec3 centre = circumcentre(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
  if (!is_finite(centre)) return true;
  std::vector<Neighbour> nearest;
  sample_.all.nearest(centre, 1, nearest);
  return std::sqrt(nearest.front().squared_distance) > empty_spacings * spacing;
}

}  // namespace geodrome
