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
inline Vec3 position_of(const TreePoint& p) { return {p.get<0>(), p.get<1>(), p.get<2>()}; }

/// A tree of those points that `wanted(place)` takes, with their places in the list. O(n log n).
template <class Wanted>
PointTree tree_of(std::span<const Vec3> points, Wanted&& wanted) {
  std::vector<PlacedPoint> entries;
  for (Index i = 0; i < points.size(); ++i)
    if (wanted(i)) entries.emplace_back(tree_point(points[i]), i);
  return PointTree(entries);
}

inline PointTree tree_of(std::span<const Vec3> points) {
  return tree_of(points, [](Index) { return true; });
}

/// The box around two points, wider by `margin` on all sides.
inline boost::geometry::model::box<TreePoint> box_around(const Vec3& a, const Vec3& b, double margin = 0) {
  return {{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::min(a.z, b.z) - margin},
          {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin, std::max(a.z, b.z) + margin}};
}

/// The places of the points that are no farther than `radius` from `centre`, in ascending order.
inline std::vector<Index> places_near(const PointTree& tree, const Vec3& centre, double radius) {
  std::vector<Index> found;
  for (auto at = tree.qbegin(boost::geometry::index::intersects(box_around(centre, centre, radius))); at != tree.qend();
       ++at)
    if (distance(position_of(at->first), centre) <= radius) found.push_back(at->second);
  std::ranges::sort(found);
  return found;
}

/// Takes the places that steps lead to from `first` out of a tree, each once, and calls `visit(place)` for them until
/// it returns false. A step leads from a place to those within `radius(place)` that `joined(place, near)` allows; where
/// that is symmetric, all that is joined is found. Of k places near each other it makes k searches that find k places
/// in all, not k squared. `taken`: the places that are not in question any more; kept up to date.
template <class Radius, class Joined, class Visit>
void take_joined(PointTree& tree, std::span<const Vec3> places, Index first, std::vector<bool>& taken, Radius&& radius,
                 Joined&& joined, Visit&& visit) {
  taken[first] = true;
  std::vector<Index> reached{first};
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const Index near : places_near(tree, places[reached[i]], radius(reached[i]))) {
      if (taken[near] || !joined(reached[i], near)) continue;
      if (!visit(near)) return;
      taken[near] = true;
      reached.push_back(near);
      tree.remove(PlacedPoint(tree_point(places[near]), near));
    }
}

}  // namespace geodrome::input
