// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tools/shapes/level_value.hpp"

namespace geodrome::shapes {

/// A star-like body: its surface is at radius(d) in the direction d, |d| = 1.
///
/// bumpy   1 + 0.25 sin(3 x + 1) cos(2 y) + 0.15 sin(4 x z + 0.5)
/// star    1 + 0.15 (x^3 - 3 x y^2) + 0.6 x y z + 0.2 (z^2 - 1/3): harmonics of degree 3, 3 and 2
struct Radial {
  std::string_view kind;
  LevelValue (*radius)(const Vec3& direction);  ///< of the formula, which means something beside the unit sphere too
};

/// The body of a kind, or null.
const Radial* find_radial(std::string_view kind);

}  // namespace geodrome::shapes
