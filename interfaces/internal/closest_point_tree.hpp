// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes a deprecated header of Boost's own
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>
#include <vector>

#include "geodrome/detail/point_triangle.hpp"
#include "geodrome/surface.hpp"

/// Needs Boost, which nothing else of the SDK does: not included by any other header of it.
namespace geodrome::detail {

/// A face and the point of it that is closest to a query.
struct FacePoint {
  Index face = no_index;
  TrianglePoint point{{}, std::numeric_limits<double>::infinity()};

  SurfacePoint at() const { return {face, point.b}; }
};

/// The order of candidates: the closest; then, at the query itself, one that is a vertex; then the lowest face.
inline bool precedes(const FacePoint& a, const FacePoint& b) {
  const double to_a = a.point.squared_distance, to_b = b.point.squared_distance;
  if (to_a != to_b) return to_a < to_b;
  const auto is_corner = [](const FacePoint& f) { return f.point.b[0] == 1 || f.point.b[1] == 1 || f.point.b[2] == 1; };
  if (to_a == 0 && is_corner(a) != is_corner(b)) return is_corner(a);
  return a.face < b.face;
}

inline FacePoint closest_on_face(const SurfaceMesh& mesh, Index face, const Vec3& query) {
  return {face, closest_on_triangle(query, mesh.corners(face))};
}

/// An R-tree over the boxes of a mesh's triangles, with the exact distance of point and triangle. Immutable;
/// thread-safe.
class ClosestPointTree {
 public:
  /// O(F log F); the range is bulk-loaded.
  explicit ClosestPointTree(MeshPtr mesh) : mesh_(std::move(mesh)), boxes_(boxes_of(*mesh_)) {}

  const SurfaceMesh& mesh() const noexcept { return *mesh_; }

  /// The first candidate, in the order of `precedes`, of all faces for which `skip(face)` is false; none: no_index and
  /// infinity. O(log F) typically.
  template <class Skip>
  FacePoint closest(const Vec3& query, Skip&& skip) const {
    const BoxPoint point(query.x, query.y, query.z);
    const std::size_t all = boxes_.size();
    FacePoint best;
    std::vector<Entry> nearest;
    // The closest boxes, more and more of them, until the farthest is farther than the best triangle. (The tree's
    // incremental iterator would do in one go, but visits a share of all nodes: a hundred times slower on a terrain of
    // 2e4 faces.)
    for (std::size_t count = std::min(first_boxes, all);; count = std::min(4 * count, all)) {
      nearest.clear();
      boxes_.query(boost::geometry::index::nearest(point, static_cast<unsigned>(count)), std::back_inserter(nearest));
      double farthest = 0;
      for (const auto& [box, face] : nearest) {
        const double to_box = boost::geometry::comparable_distance(point, box);
        farthest = std::max(farthest, to_box);
        if (to_box > best.point.squared_distance * (1 + rounding_slack) || skip(face)) continue;
        const FacePoint candidate = closest_on_face(*mesh_, face, query);
        if (best.face == no_index || precedes(candidate, best)) best = candidate;
      }
      if (count == all || farthest > best.point.squared_distance * (1 + rounding_slack)) return best;
    }
  }

  FacePoint closest(const Vec3& query) const {
    return closest(query, [](Index) { return false; });
  }

 private:
  using BoxPoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<BoxPoint>;
  using Entry = std::pair<Box, Index>;

  /// Boxes whose squared distance exceeds the best one by less than this share are still looked into: the distances to
  /// a box and to a triangle in it are rounded differently, by a few units in the last place.
  static constexpr double rounding_slack = 1e-12;

  /// Boxes looked into at first: enough for most points near a surface, whose vertices have six faces.
  static constexpr std::size_t first_boxes = 12;

  static Box box_of(const std::array<Vec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
            {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
  }

  static std::vector<Entry> boxes_of(const SurfaceMesh& mesh) {
    std::vector<Entry> boxes;
    boxes.reserve(mesh.face_count());
    for (Index face = 0; face < mesh.face_count(); ++face) boxes.emplace_back(box_of(mesh.corners(face)), face);
    return boxes;
  }

  MeshPtr mesh_;
  boost::geometry::index::rtree<Entry, boost::geometry::index::linear<16>> boxes_;
};

}  // namespace geodrome::detail
