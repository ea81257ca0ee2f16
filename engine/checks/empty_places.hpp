// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A disc of the surface of a sample that holds no point of it.
struct EmptyPlace {
  double radius = 0;
  double missing = 0;  ///< points that would be in it if they lay as densely as around it
  Index nearest_row = no_index;
};

/// The place without points in which most are missing, if they are more than chance leaves out among points that are
/// spread at random: an opening that the surface may have closed. Points count where they project to. O(n log n).
std::optional<EmptyPlace> widest_empty_place(const Input& input, const PlacedSurface& surface);

}  // namespace geodrome
