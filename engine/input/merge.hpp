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

/// The vertices that merging within a tolerance joins.
struct MergedWithin {
  MergedPoints merged;
  double moved = 0;  ///< the largest distance of a point from the one that it was merged into
  /// A point that a chain of points, each within the tolerance of the next, would move farther than the tolerance, and
  /// the one that it would be merged into; no_index: there is none, and `merged` is whole.
  Index chained = no_index, chained_to = no_index;
};

/// Merges points that are joined by steps of at most `tolerance` into the first of them: within a tolerance is not
/// transitive, so what would move farther than the tolerance is told instead. Preconditions as above. O(n log n).
MergedWithin merge_points_within(std::span<const Vec3> points, double tolerance);

/// Merges the vertices of a soup whose format names them by their places alone. Preconditions and cost as above.
void merge_vertices(Soup& soup);

}  // namespace geodrome::input
