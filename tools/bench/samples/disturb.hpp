// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geodrome/geometry.hpp"

/// What is done to a sample to make it harder. Same arguments, same bytes.
namespace geodrome::bench {

/// Adds outliers behind the points: round(share * size) of them, uniform in the bounding box enlarged by 10 % (each
/// side 1.1 times as long, the same centre). Preconditions: at least one point; share >= 0.
PointSample with_outliers(PointSample sample, double share, std::uint64_t seed);

/// Moves each coordinate by up to `size` either way, uniformly.
PointSample jittered(PointSample sample, double size, std::uint64_t seed);

}  // namespace geodrome::bench
