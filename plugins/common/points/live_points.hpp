// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/tangent_estimator.hpp"

namespace geodrome {

/// The points of a sample that were not dropped, packed: later stages work on these alone.
struct LivePoints {
  std::vector<Vec3> points;
  std::vector<Index> sample_index;  ///< of each packed point, ascending

  std::size_t size() const noexcept { return points.size(); }
};

/// Packs the points. `state` has one entry per point of `sample`. O(n).
LivePoints live_points(const PointSample& sample, std::span<const PointState> state);

}  // namespace geodrome
