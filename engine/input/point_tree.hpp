// SPDX-License-Identifier: MIT
#pragma once

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes a deprecated header of Boost's own
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <span>
#include <utility>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome::input {

using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using PlacedPoint = std::pair<TreePoint, Index>;
using PointTree = boost::geometry::index::rtree<PlacedPoint, boost::geometry::index::linear<16>>;

inline TreePoint tree_point(const Vec3& p) { return {p.x, p.y, p.z}; }

/// A tree of points with their places in the list. O(n log n).
inline PointTree tree_of(std::span<const Vec3> points) {
  std::vector<PlacedPoint> entries;
  for (Index i = 0; i < points.size(); ++i) entries.emplace_back(tree_point(points[i]), i);
  return PointTree(entries);
}

/// The places of the points that are no farther than `radius` from `centre`, in ascending order.
inline std::vector<Index> places_near(const PointTree& tree, const Vec3& centre, double radius) {
  const Vec3 reach{radius, radius, radius};
  const boost::geometry::model::box<TreePoint> box(tree_point(centre - reach), tree_point(centre + reach));
  std::vector<Index> found;
  for (auto at = tree.qbegin(boost::geometry::index::intersects(box)); at != tree.qend(); ++at) {
    const TreePoint& p = at->first;
    if (distance({p.get<0>(), p.get<1>(), p.get<2>()}, centre) <= radius) found.push_back(at->second);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace geodrome::input
