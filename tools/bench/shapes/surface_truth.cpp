// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/surface_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geodrome/errors.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr double most_seconds = 3600;  // for one search; none is expected to hang

/// The sphere's other mesh has poles.
MeshPtr mesh_of(const std::string& shape, std::size_t faces) {
  return std::make_shared<const SurfaceMesh>(shapes::mesh(shape == "sphere" ? "icosphere" : shape, faces));
}

double mean_edge(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h)
    sum += geodrome::distance(mesh.positions()[mesh.from(h)], mesh.positions()[mesh.to(h)]);
  return sum / (3.0 * static_cast<double>(mesh.face_count()));
}

/// How far apart two paths are where they have come the same share of their length.
double gap_between(std::span<const Vec3> a, std::span<const Vec3> b) {
  constexpr std::size_t places = 32;
  const std::vector<Vec3> p = resampled(a, places), q = resampled(b, places);
  double widest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) widest = std::max(widest, geodrome::distance(p[i], q[i]));
  return widest;
}

/// The path moved to start at the target, less and less along it: without a fold, wherever the target lies beside its
/// first point. The end stays.
std::vector<Vec3> bent_to(const Vec3& target, std::vector<Vec3> path) {
  constexpr double slow = 4;  // times the move: the angles of the path change by 1/4 at most
  const Vec3 move = target - path.front();
  const double reach = std::min(slow * norm(move), length_of(path));
  double passed = 0;
  Vec3 before = path.front();
  const Vec3 end = path.back();
  for (Vec3& p : path) {
    passed += geodrome::distance(before, p);
    before = p;
    p = p + std::max(0.0, 1 - passed / reach) * move;
  }
  path.front() = target, path.back() = end;  // to the last bit
  return path;
}

}  // namespace

SurfaceTruth::SurfaceTruth(const std::string& shape, std::size_t faces, const Plugin<ShortestPathSolver>& solver)
    : level_(level_set_of(shape)),
      mesh_(mesh_of(shape, faces)),
      locator_(mesh_),
      solver_(solver, mesh_, most_seconds),
      edge_(mean_edge(*mesh_)) {}

void SurfaceTruth::start(const Vec3& source) {
  source_ = source;
  const Source from{locator_.closest(source).at};
  solver_.run({&from, 1}, {.keep = Keep::map});
}

std::vector<double> SurfaceTruth::rough(std::span<const Vec3> points) const {
  std::vector<SurfacePoint> places;
  for (const Vec3& p : points) places.push_back(locator_.closest(p).at);
  return solver_.at(places);
}

std::vector<Vec3> SurfaceTruth::rough_path(const Vec3& target) const {
  std::vector<Vec3> path;
  for (const SurfacePoint& p : solver_.traced(locator_.closest(target).at)) path.push_back(mesh_->position(p));
  path.front() = target, path.back() = source_;
  return path;
}

std::vector<std::vector<Vec3>> SurfaceTruth::starts(const Vec3& target) const {
  constexpr double radii[] = {1, 4, 16};  // edges: the nearer of two cut points may be far where they are nearly one
  constexpr double most_turn = 0.5;       // what is farther on a curved surface is no longer beside the target
  constexpr int directions = 6;
  std::vector<std::vector<Vec3>> kept{rough_path(target)};
  const Vec3 normal = normal_at(level_, target), least = std::abs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 side = cross(normal, least) / norm(cross(normal, least)), other = cross(normal, side);
  const double farthest = most_turn / curvature_bound(level_, target);
  for (const double radius : radii)
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * std::numbers::pi * k / directions, away = std::min(radius * edge_, farthest);
      const Vec3 direction = std::cos(angle) * side + std::sin(angle) * other;
      std::vector<Vec3> path = bent_to(target, rough_path(shoot(level_, target, direction, away).end));
      const auto same = [&](const std::vector<Vec3>& known) { return gap_between(path, known) < 2 * away; };
      if (std::ranges::none_of(kept, same)) kept.push_back(std::move(path));
    }
  return kept;
}

double SurfaceTruth::distance(const Vec3& target) const {
  constexpr double most_missed = 0.05;  // of what is near by a mesh that shows the shape
  if (target == source_) return 0;
  const std::vector<std::vector<Vec3>> paths = starts(target);
  double least = shortened(level_, paths.front()).length;
  for (std::size_t i = 1; i < paths.size(); ++i) {
    try {
      least = std::min(least, shortened(level_, paths[i]).length);
    } catch (const NumericalError&) {  // no minimum is near: another way that is none
    }
  }
  const double rough = solver_.at(std::vector{locator_.closest(target).at}).front();
  if (!(std::abs(least - rough) <= most_missed * rough))
    throw NumericalError("a geodesic of length " + std::to_string(least) + " where the mesh's is " +
                         std::to_string(rough) + " long");
  return least;
}

}  // namespace geodrome::bench
