// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// The indices of the points along a Z-order curve (Morton), ties by index. A loop of neighbour searches in this order
/// finds the tree in the cache: several times faster for a million points. Points must be finite. O(n log n).
std::vector<Index> spatial_order(std::span<const Vec3> points);

}  // namespace geodrome
