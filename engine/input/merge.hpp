// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/formats/soup.hpp"
#include "geodrome/geometry.hpp"

namespace geodrome::input {

/// Points without repetitions, in the order of their first appearance.
struct MergedPoints {
  std::vector<Vec3> positions;
  std::vector<Index> element_of_row;  ///< given point -> entry of `positions`
};

/// Merges points at exactly the same place (-0 and 0 are the same) into the first of them. Precondition: finite points,
/// fewer than no_index. O(n log n).
MergedPoints merge_equal_points(std::span<const Vec3> points);

/// Merges the vertices of a soup whose format names them by their places alone. Preconditions and cost as above.
void merge_vertices(Soup& soup);

}  // namespace geodrome::input
