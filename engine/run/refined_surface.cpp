// SPDX-License-Identifier: MIT
#include "engine/run/refined_surface.hpp"

#include <algorithm>
#include <map>

namespace geodrome {

namespace {

/// The vertices in the middles of edges, made where they are first needed.
class Middles {
 public:
  explicit Middles(std::vector<Vec3>& positions) : positions_(positions) {}

  Index of(Index a, Index b) {
    const auto [entry, is_new] = known_.emplace(std::minmax(a, b), static_cast<Index>(positions_.size()));
    // Halves first, or the sum of two huge coordinates overflows.
    if (is_new) positions_.push_back(0.5 * positions_[a] + 0.5 * positions_[b]);
    return entry->second;
  }

 private:
  std::vector<Vec3>& positions_;
  std::map<std::pair<Index, Index>, Index> known_;
};

Place on_refined(const Place& place, const SurfaceMesh& mesh) {
  Place result = place;
  if (place.state == Place::State::on_surface)
    result.at = place.vertex != no_index ? mesh.at_vertex(place.vertex) : on_quarter(place.at);
  if (result.vertex == no_index && place.state == Place::State::on_surface) result.vertex = mesh.vertex_at(result.at);
  return result;
}

std::vector<Query> on_refined(std::span<const Query> queries, const SurfaceMesh& mesh) {
  std::vector<Query> result(queries.begin(), queries.end());
  for (Query& query : result) query.place = on_refined(query.place, mesh);
  return result;
}

}  // namespace

SurfaceMesh cut_in_four(const SurfaceMesh& mesh) {
  std::vector<Vec3> positions(mesh.positions().begin(), mesh.positions().end());
  std::vector<Triangle> triangles;
  std::vector<double> weights;
  triangles.reserve(4 * mesh.face_count());
  Middles middle(positions);
  for (const auto& [a, b, c] : mesh.triangles()) {
    const Index ab = middle.of(a, b), bc = middle.of(b, c), ca = middle.of(c, a);
    triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  for (const double weight : mesh.face_weights()) weights.insert(weights.end(), 4, weight);
  return SurfaceMesh(std::move(positions), std::move(triangles), std::move(weights));
}

SurfacePoint on_quarter(const SurfacePoint& point) {
  const auto& [a, b, c] = point.b;
  const Index first = 4 * point.face;
  if (a >= 0.5) return {first, {2 * a - 1, 2 * b, 2 * c}};
  if (b >= 0.5) return {first + 1, {2 * a, 2 * b - 1, 2 * c}};
  if (c >= 0.5) return {first + 2, {2 * a, 2 * b, 2 * c - 1}};
  return {first + 3, {1 - 2 * c, 1 - 2 * a, 1 - 2 * b}};  // of the middles ab, bc, ca
}

std::shared_ptr<const ComparedSurface> refined(const ComparedSurface& coarse) {
  auto surface = std::make_shared<Surface>();
  surface->made_from = InputKind::mesh;
  surface->mesh = std::make_shared<const SurfaceMesh>(cut_in_four(*coarse.surface->mesh));
  for (const Place& place : coarse.surface->places) surface->places.push_back(on_refined(place, *surface->mesh));
  TargetList targets(on_refined(coarse.targets.queries(), *surface->mesh), *surface);
  return std::make_shared<const ComparedSurface>(
      ComparedSurface{surface, on_refined(coarse.sources, *surface->mesh), std::move(targets)});
}

}  // namespace geodrome
