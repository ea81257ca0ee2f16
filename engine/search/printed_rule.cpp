// SPDX-License-Identifier: MIT
#include "engine/search/printed_rule.hpp"

#include <iterator>
#include <utility>

#include "engine/input/point_tree.hpp"
#include "geodrome/detail/point_triangle.hpp"

namespace geodrome {

namespace bgi = boost::geometry::index;

namespace {

/// Vertices as far as the nearest one to this share are compared once more, one by one, so that ties are found.
constexpr double rounding_slack = 1e-12;

}  // namespace

struct VertexLocator::Impl {
  input::PointTree tree;
};

VertexLocator::VertexLocator(const SurfaceMesh& mesh)
    : impl_(std::make_unique<const Impl>(
          Impl{input::tree_of(mesh.positions(), [&](Index v) { return mesh.first_half_edge(v) != no_index; })})) {}

VertexLocator::~VertexLocator() = default;

Index VertexLocator::nearest(const Vec3& query) const {
  std::vector<input::PlacedPoint> found;
  impl_->tree.query(bgi::nearest(input::tree_point(query), 1), std::back_inserter(found));
  if (found.empty()) return no_index;
  const double radius = distance(query, input::position_of(found[0].first)) * (1 + rounding_slack);
  impl_->tree.query(bgi::intersects(input::box_around(query, query, radius)), std::back_inserter(found));
  std::pair<double, Index> best{infinity, no_index};
  for (const auto& [point, vertex] : found)
    best = std::min(best, {squared_distance(query, input::position_of(point)), vertex});
  return best.second;
}

std::vector<SurfacePoint> closest_on_faces_at(const SurfaceMesh& mesh, Index vertex, const Vec3& query) {
  std::vector<SurfacePoint> points;
  const auto add = [&](Index half_edge) {
    const Index face = SurfaceMesh::face(half_edge);
    points.push_back({face, detail::closest_on_triangle(query, mesh.corners(face)).b});
  };
  const Index first = mesh.first_half_edge(vertex);
  Index h = first;
  do {  // counter-clockwise, around or to the boundary
    add(h);
    h = mesh.twins()[SurfaceMesh::previous(h)];
  } while (h != no_index && h != first);
  if (h == first) return points;
  for (Index twin = mesh.twins()[first]; twin != no_index; twin = mesh.twins()[h]) {  // what is left, clockwise
    h = SurfaceMesh::next(twin);
    add(h);
  }
  return points;
}

}  // namespace geodrome
