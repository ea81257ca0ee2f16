// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome::aleksandrov {

/// Appends to `out` first + i for each i < count at which the point (x - t[i] dx, y - t[i] dy) is within
/// best[i] - base of the origin: where a way of length `base` to there would not be longer than the best one. The same
/// on every processor.
void scan_strip(const double* t, const double* best, std::size_t count, double base, double x, double y, double dx,
                double dy, Index first, std::vector<Index>& out);

}  // namespace geodrome::aleksandrov
