// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A point of a triangle, with its squared distance from the point it was sought for.
struct TrianglePoint {
  std::array<double, 3> b{};  ///< barycentric coordinates, >= 0, sum 1 to rounding; exactly 1 and 0 at a corner
  double squared_distance = 0;
};

/// The point of a triangle that is closest to `query`. The triangle may be degenerate: a segment or a point. Two
/// triangles that share an edge in opposite directions get bitwise the same distance where the closest point is on that
/// edge. O(1).
TrianglePoint closest_on_triangle(const Vec3& query, const std::array<Vec3, 3>& corners);

}  // namespace geodrome
