// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "geodrome/engine/input.hpp"

namespace geodrome::input {

/// Finds open edges that lie on other open edges within rounding, as the two sides of a seam whose coordinates were
/// computed twice, and tells of them in `input.findings` with the tolerance of welding that would join them. Where all
/// lie on each other exactly, which is told as equal positions, they are told if components would be joined. Tells too
/// of open edges that lie along a longer one, as where one side has more vertices: no welding joins these.
/// Precondition: positions, triangles and the diagonal are set. O(n log n).
void tell_coincident_edges(std::span<const std::array<Index, 2>> open_edges, Input& input);

}  // namespace geodrome::input
