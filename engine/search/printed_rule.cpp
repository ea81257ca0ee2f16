// SPDX-License-Identifier: MIT
#include "engine/search/printed_rule.hpp"

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes a deprecated header of Boost's own
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>

#include "geodrome/detail/point_triangle.hpp"

namespace geodrome {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

namespace {

using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<Point, Index>;

/// Vertices as far as the nearest one to this share are compared once more, one by one, so that ties are found.
constexpr double rounding_slack = 1e-12;

std::vector<Entry> entries_of(const SurfaceMesh& mesh) {
  std::vector<Entry> entries;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.positions()[v];
    if (mesh.first_half_edge(v) != no_index) entries.emplace_back(Point(p.x, p.y, p.z), v);
  }
  return entries;
}

Vec3 vec3(const Point& p) { return {bg::get<0>(p), bg::get<1>(p), bg::get<2>(p)}; }

}  // namespace

struct VertexLocator::Impl {
  bgi::rtree<Entry, bgi::linear<16>> tree;
};

VertexLocator::VertexLocator(const SurfaceMesh& mesh)
    : impl_(std::make_unique<const Impl>(Impl{bgi::rtree<Entry, bgi::linear<16>>(entries_of(mesh))})) {}

VertexLocator::~VertexLocator() = default;

Index VertexLocator::nearest(const Vec3& query) const {
  std::vector<Entry> found;
  impl_->tree.query(bgi::nearest(Point(query.x, query.y, query.z), 1), std::back_inserter(found));
  if (found.empty()) return no_index;
  const double radius = distance(query, vec3(found[0].first)) * (1 + rounding_slack);
  const bg::model::box<Point> box(Point(query.x - radius, query.y - radius, query.z - radius),
                                  Point(query.x + radius, query.y + radius, query.z + radius));
  impl_->tree.query(bgi::intersects(box), std::back_inserter(found));
  std::pair<double, Index> best{infinity, no_index};
  for (const auto& [point, vertex] : found) best = std::min(best, {squared_distance(query, vec3(point)), vertex});
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
