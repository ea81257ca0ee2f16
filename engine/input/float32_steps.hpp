// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "geodrome/engine/input.hpp"

namespace geodrome::input {

/// The largest step between neighbouring values of float32 at the coordinates, if all of them are such values and,
/// where the step is largest, look rounded to it: a quarter or more use the last bit. 0 otherwise. O(n).
double float32_step(std::span<const Vec3> positions);

/// Tells in `input.findings` of coordinates that come in steps of float32 which are not small against the spacing:
/// the median length of the edges of a mesh, the median distance of points of a cloud from the nearest other one. Far
/// from the origin, as in metres of a map, such steps bend the surface. O(n), and O(n log n) for a cloud in doubt.
void tell_float32_steps(Input& input);

}  // namespace geodrome::input
