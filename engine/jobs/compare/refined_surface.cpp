// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/refined_surface.hpp"

#include "geodrome/quarter.hpp"

namespace geodrome {

namespace {

Place on_refined(const Place& place, const SurfaceMesh& mesh) {
  Place result = place;
  if (place.state == Place::State::on_surface)
    result.at = place.vertex != no_index ? mesh.at_vertex(place.vertex) : on_quarter(place.at);
  if (result.vertex == no_index && place.state == Place::State::on_surface) result.vertex = mesh.vertex_at(result.at);
  return result;
}

std::vector<NamedPoint> on_refined(std::span<const NamedPoint> queries, const SurfaceMesh& mesh) {
  std::vector<NamedPoint> result(queries.begin(), queries.end());
  for (NamedPoint& query : result) query.place = on_refined(query.place, mesh);
  return result;
}

}  // namespace

SurfaceMesh cut_in_four(const SurfaceMesh& mesh) {
  std::vector<Vec3> positions(mesh.positions().begin(), mesh.positions().end());
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  std::vector<double> weights;
  // Halves first, or the sum of two huge coordinates overflows.
  quarter(positions, triangles, [](const Vec3& p, const Vec3& q) { return 0.5 * p + 0.5 * q; });
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
  auto surface = std::make_shared<PlacedSurface>();
  surface->made_from = InputKind::mesh;
  surface->mesh = std::make_shared<const SurfaceMesh>(cut_in_four(*coarse.surface->mesh));
  for (const Place& place : coarse.surface->places) surface->places.push_back(on_refined(place, *surface->mesh));
  TargetList targets(on_refined(coarse.targets.named(), *surface->mesh), *surface);
  return std::make_shared<const ComparedSurface>(
      ComparedSurface{surface, on_refined(coarse.sources, *surface->mesh), std::move(targets)});
}

}  // namespace geodrome
