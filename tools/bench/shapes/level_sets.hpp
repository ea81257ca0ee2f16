// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/shapes/level_value.hpp"

/// The smooth closed shapes of `shapes::sample` as surfaces f = 0, with the derivatives that geodesics need.
namespace geodrome::bench {

using shapes::LevelValue;

/// A function that is 0 on a shape, smooth and without critical point close to it.
using LevelSet = LevelValue (*)(const Vec3&);

/// The shapes that have one: sphere, ellipsoid, torus, trefoil, genus2, genus5, bumpy, star.
const std::vector<std::string>& smooth_shapes();

/// The function of a shape. Throws OptionError for a shape that is not in `smooth_shapes`.
LevelSet level_set_of(const std::string& shape);

/// The least local feature size of a shape, the distance to its medial axis, where it is known and the same everywhere:
/// sphere 1; torus 0.4, the radius of the tube (the core circle is that far from every point, the axis at least 0.6);
/// trefoil 0.1 likewise (strands are 0.2 from the middle between two, less the radius 0.1, and centres of curvature at
/// least 1/2.34 - 0.1).
std::optional<double> feature_size(const std::string& shape);

/// The point of the surface that Newton's method along the gradient reaches. Precondition: the point is near.
Vec3 on_level_set(LevelSet level, Vec3 point);

}  // namespace geodrome::bench
