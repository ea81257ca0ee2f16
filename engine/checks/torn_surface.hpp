// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// Two rows of a sample that are neighbours there but on parts of the surface that do not meet, if there are such: the
/// surface fell apart where the sample does not. O(n log n); O(F) for a surface of one component.
std::optional<std::pair<Index, Index>> torn_neighbours(const Input& input, const PlacedSurface& surface);

}  // namespace geodrome
