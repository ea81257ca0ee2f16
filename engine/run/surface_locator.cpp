// SPDX-License-Identifier: MIT
#include "geodrome/engine/surface_locator.hpp"

#include <algorithm>
#include <array>
#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes a deprecated header of Boost's own
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "engine/run/point_triangle.hpp"

namespace geodrome {
namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
namespace {

using BoxPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<BoxPoint>;
using Entry = std::pair<Box, Index>;

/// Boxes whose squared distance exceeds the best one by less than this share are still looked into: the distances to a
/// box and to a triangle in it are rounded differently, by a few units in the last place.
constexpr double rounding_slack = 1e-12;

/// Boxes looked into at first: enough for most points near a surface, whose vertices have six faces.
constexpr std::size_t first_boxes = 12;

Box box_of(const std::array<Vec3, 3>& corners) {
  const auto [a, b, c] = corners;
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

std::vector<Entry> boxes_of(const SurfaceMesh& mesh) {
  std::vector<Entry> boxes;
  boxes.reserve(mesh.face_count());
  for (Index face = 0; face < mesh.face_count(); ++face) boxes.emplace_back(box_of(mesh.corners(face)), face);
  return boxes;
}

/// The closest candidate; then, at the point itself, one that is a vertex; then the lowest face.
bool precedes(const TrianglePoint& a, Index face_a, const TrianglePoint& b, Index face_b) {
  if (a.squared_distance != b.squared_distance) return a.squared_distance < b.squared_distance;
  const auto is_corner = [](const TrianglePoint& point) { return std::ranges::find(point.b, 1.0) != point.b.end(); };
  if (a.squared_distance == 0 && is_corner(a) != is_corner(b)) return is_corner(a);
  return face_a < face_b;
}

}  // namespace

struct SurfaceLocator::Impl {
  explicit Impl(MeshPtr surface) : mesh(std::move(surface)), boxes(boxes_of(*mesh)) {}  // the range is bulk-loaded

  MeshPtr mesh;
  bgi::rtree<Entry, bgi::linear<16>> boxes;
};

SurfaceLocator::SurfaceLocator(MeshPtr mesh) {
  if (!mesh || mesh->face_count() == 0)
    throw InputError(InputFault::empty, "there is no surface to look for closest points on: the mesh has no face");
  impl_ = std::make_unique<const Impl>(std::move(mesh));
}

SurfaceLocator::~SurfaceLocator() = default;

ClosestPoint SurfaceLocator::closest(const Vec3& query) const {
  if (!is_finite(query)) throw InputError(InputFault::nonfinite, "a point to be located on the surface is not finite");
  const BoxPoint point(query.x, query.y, query.z);
  const std::size_t all = impl_->boxes.size();
  TrianglePoint best{{}, std::numeric_limits<double>::infinity()};
  Index best_face = no_index;
  std::vector<Entry> nearest;
  // The closest boxes, more and more of them, until the farthest is farther than the best triangle. (The tree's
  // incremental iterator would do in one go, but visits a share of all nodes: a hundred times slower on a terrain of
  // 2e4 faces.)
  for (std::size_t count = std::min(first_boxes, all);; count = std::min(4 * count, all)) {
    nearest.clear();
    impl_->boxes.query(bgi::nearest(point, static_cast<unsigned>(count)), std::back_inserter(nearest));
    double farthest = 0;
    for (const auto& [box, face] : nearest) {
      const double to_box = bg::comparable_distance(point, box);
      farthest = std::max(farthest, to_box);
      if (to_box > best.squared_distance * (1 + rounding_slack)) continue;
      const TrianglePoint candidate = closest_on_triangle(query, impl_->mesh->corners(face));
      if (best_face != no_index && !precedes(candidate, face, best, best_face)) continue;
      best = candidate;
      best_face = face;
    }
    if (count == all || farthest > best.squared_distance * (1 + rounding_slack)) break;
  }
  return {{best_face, best.b}, std::sqrt(best.squared_distance)};
}

}  // namespace geodrome
