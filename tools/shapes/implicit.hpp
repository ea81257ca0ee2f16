// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tools/shapes/level_value.hpp"

namespace geodrome::shapes {

/// A surface f = 0 without parametrisation, regular (no zero of the gradient on it), inside a box around the origin.
///
/// genus2   (x^2 - x^4 - y^2)^2 + z^2 = 0.03. Where the gradient vanishes the left side is 0 or 1/16: regular.
/// genus5   x^2 + y^2 + 4 z^2 + sum of 1.3 exp(-25 |(x, y) - c_k|^2) = 1, the five c_k on a circle of radius 0.55: a
/// disc-like
///          pillow with five holes. Its critical points lie in z = 0, at the centres of the holes (above 1) and between
///          them (below 1).
struct Implicit {
  std::string_view kind;
  LevelValue (*at)(const Vec3&);
  Vec3 half_extent;          ///< the surface is strictly inside [-half_extent, half_extent]
  double second_derivative;  ///< bounds |d^2 f| in every direction, all over the box
  double coarsest;           ///< grids with larger cells do not show the shape
  int genus;
};

/// The surface of a kind, or null.
const Implicit* find_implicit(std::string_view kind);

/// The point of the surface that Newton's method along the gradient reaches: for points close to the surface, to
/// rounding the point of the surface next to them. Throws NumericalError if it does not settle.
Vec3 project(const Implicit& surface, Vec3 point);

}  // namespace geodrome::shapes
