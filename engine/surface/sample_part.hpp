// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A part has at least so many points, and this share of the sample: less may look like a surface by chance.
inline constexpr std::size_t least_part = 100;
inline constexpr double least_part_share = 0.01;

/// Whether so many points of a sample are enough for a part.
inline bool enough_for_part(std::size_t points, std::size_t sample) {
  return points >= least_part && static_cast<double>(points) >= least_part_share * static_cast<double>(sample);
}

/// Parts of a sample that look like one surface each, as ascending points, the largest part first: what one is worth,
/// the stages must say. `stages` has the tangent planes of the whole sample.
///
/// Every point gets the mean plane of its 24 (96) nearest: the mean of these points, and of their normals, turned to
/// one side. A point looks like one of a surface if these points lie within 0.15 (0.1) of their radius of that plane,
/// root mean square (uniform in space it is 0.45), itself at most three times as high, and at least seven tenths of the
/// 12 nearest have planes that agree with its own: turned by 25 degrees at most, and neither point steeper than 0.25
/// above the other's plane. A part is what agreeing neighbours connect whose radii differ by a factor below 2. Each of
/// the four choices of scale and flatness gives its largest part, those with enough points count. O(n log n); 400 bytes
/// a point.
std::vector<std::vector<Index>> part_candidates(const SampleStages& stages, Observer& observer);

}  // namespace geodrome
