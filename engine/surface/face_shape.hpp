// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// Lengths, angles and radii of one triangle; index i stands for corner i and the edge opposite to it.
struct FaceShape {
  std::array<double, 3> length{}, angle{};  ///< angles in radians
  double edge_ratio = 1;                    ///< longest to shortest edge; +inf if an edge has length 0
  double circumradius = 0;                  ///< +inf for three points on a line
};

inline FaceShape shape_of(const std::array<Vec3, 3>& p) {
  FaceShape shape;
  shape.length = {distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1])};
  const double twice_area = norm(cross(p[1] - p[0], p[2] - p[0]));
  for (int i = 0; i < 3; ++i)
    shape.angle[i] = std::atan2(twice_area, dot(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]));
  const auto [shortest, longest] = std::minmax_element(shape.length.begin(), shape.length.end());
  shape.edge_ratio = *longest / *shortest;
  shape.circumradius = shape.length[0] * shape.length[1] * shape.length[2] / (2 * twice_area);
  return shape;
}

}  // namespace geodrome
