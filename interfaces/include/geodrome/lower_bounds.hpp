// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "geodrome/shortest_path_map.hpp"

namespace geodrome {

/// Extension (README.md, "Extensions") of a solver that knows beside each distance D how short the true one, d, can be
/// at least: l. All of them are from the nearest source, its start distance included, and in the units of the mesh. Up
/// to rounding (1e-12 of the largest distance)
///
///     0 <= l <= d,   l <= D,   |d - D| <= D - l,   and D <= factor l where the descriptor's factor is finite.
///
/// So d lies in [l, D] where no distance is below the true one, else in [l, 2 D - l].
///
/// Where nothing was reached: if there is no path, l is +inf; if the radius or an early stop is the reason, l is finite
/// and still at most d. It is then the limit up to which the search is complete, or less where a shorter way that the
/// search has seen may be the path.
///
/// The maps are those that a search of this plugin returned, valid until its next run.
struct LowerBounds {
  static constexpr const char* id = "geodrome.lower_bounds/1";

  /// Writes l of every vertex, by the mesh's own numbers. Precondition: as many numbers as the mesh has vertices. O(V).
  void (*of_vertices)(const ShortestPathMap& map, std::span<double> bounds) noexcept;

  /// Returns l of a point that `ShortestPathMap::at` may be asked for, and throws what that throws. O(query).
  double (*at)(const ShortestPathMap& map, const SurfacePoint& point);
};

}  // namespace geodrome
