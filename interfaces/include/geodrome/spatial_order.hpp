// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {
namespace detail {

/// Puts two zero bits between any two of the lower 21 bits.
inline std::uint64_t spread_bits(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

}  // namespace detail

/// Returns the indices of the points along a Z-order curve (Morton), ties by index. A loop of neighbour searches in
/// this order finds the tree in the cache: several times faster for a million points. Points must be finite. O(n log
/// n). Thread-safe.
inline std::vector<Index> spatial_order(std::span<const Vec3> points) {
  if (points.empty()) return {};
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double cells = extent > 0 ? ((1 << 21) - 1) / extent : 0;
  const auto cell = [&](double offset) { return static_cast<std::uint64_t>(offset * cells); };

  std::vector<std::pair<std::uint64_t, Index>> coded;
  coded.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i] - low;
    coded.emplace_back(
        detail::spread_bits(cell(p.x)) << 2 | detail::spread_bits(cell(p.y)) << 1 | detail::spread_bits(cell(p.z)), i);
  }
  std::sort(coded.begin(), coded.end());
  std::vector<Index> order;
  order.reserve(coded.size());
  for (const auto& [code, i] : coded) order.push_back(i);
  return order;
}

}  // namespace geodrome
