// SPDX-License-Identifier: MIT
#include "engine/surface/nearest_points.hpp"

#include <algorithm>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <iterator>
#include <utility>

namespace geodrome {

namespace {

namespace bgi = boost::geometry::index;
using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using PointEntry3 = std::pair<TreePoint, Index>;

TreePoint tree_point(const Vec3& p) { return {p.x, p.y, p.z}; }

std::vector<PointEntry3> entries_of(std::span<const Vec3> points) {
  std::vector<PointEntry3> entries;
  entries.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) entries.emplace_back(tree_point(points[i]), i);
  return entries;
}

}  // namespace

struct NearestPoints::Impl {
  bgi::rtree<PointEntry3, bgi::linear<16>> tree;
};

NearestPoints::NearestPoints(std::span<const Vec3> points)
    : impl_(std::make_unique<const Impl>(Impl{bgi::rtree<PointEntry3, bgi::linear<16>>(entries_of(points))})) {}

NearestPoints::~NearestPoints() = default;

std::vector<Index> NearestPoints::nearest(const Vec3& query, std::size_t k) const {
  std::vector<std::pair<double, Index>> found;
  const auto keep = [&](const PointEntry3& entry) {
    const TreePoint& p = entry.first;
    found.emplace_back(squared_distance(query, {p.get<0>(), p.get<1>(), p.get<2>()}), entry.second);
  };
  impl_->tree.query(bgi::nearest(tree_point(query), static_cast<unsigned>(k)),
                    boost::make_function_output_iterator(keep));
  std::ranges::sort(found);
  std::vector<Index> result;
  for (const auto& [squared, index] : found) result.push_back(index);
  return result;
}

}  // namespace geodrome
