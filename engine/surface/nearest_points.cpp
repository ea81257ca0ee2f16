// SPDX-License-Identifier: MIT
#include "engine/surface/nearest_points.hpp"

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>

#include "engine/input/point_tree.hpp"

namespace geodrome {

struct NearestPoints::Impl {
  input::PointTree tree;
};

NearestPoints::NearestPoints(std::span<const Vec3> points)
    : impl_(std::make_unique<const Impl>(Impl{input::tree_of(points)})) {}

NearestPoints::~NearestPoints() = default;

std::vector<Index> NearestPoints::nearest(const Vec3& query, std::size_t k) const {
  std::vector<std::pair<double, Index>> found;
  const auto keep = [&](const input::PlacedPoint& near) {
    found.emplace_back(squared_distance(query, input::position_of(near.first)), near.second);
  };
  impl_->tree.query(boost::geometry::index::nearest(input::tree_point(query), static_cast<unsigned>(k)),
                    boost::make_function_output_iterator(keep));
  std::ranges::sort(found);
  std::vector<Index> result;
  for (const auto& [squared, index] : found) result.push_back(index);
  return result;
}

}  // namespace geodrome
