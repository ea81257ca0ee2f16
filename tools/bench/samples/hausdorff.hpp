// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geodrome/surface.hpp"

namespace geodrome::bench {

/// How far the points of one surface lie from another: units of the input.
struct SurfaceGap {
  double largest = 0, mean = 0;  ///< over points drawn by area; the largest over the vertices too
};

/// Distances of `samples` points of `from`, drawn uniformly by area, and of the vertices its faces use, from their
/// closest points of `to`. `largest` is a lower bound of the one-sided Hausdorff distance, and close to it where the
/// drawn points are dense. Throws InputError (empty) if a mesh has no face. O(samples log F).
SurfaceGap surface_gap(const MeshPtr& from, const MeshPtr& to, std::size_t samples, std::uint64_t seed);

}  // namespace geodrome::bench
