// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// Returns a unit vector at a right angle to the unit vector `normal`: from the axis that is farthest from it, so that
/// nothing cancels.
inline Vec3 tangent_to(const Vec3& normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 t = cross(normal, axis);
  return t / norm(t);
}

}  // namespace geodrome
