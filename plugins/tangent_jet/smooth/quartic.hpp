// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// How many coefficients a polynomial of degree four in x and y has.
inline constexpr int quartic_size = 15;
inline constexpr int quartic_degree = 4;

/// The degrees of the monomials 1, x, y, x^2, xy, y^2, x^3, x^2 y, ..., y^4, and their values.
inline constexpr std::array<int, quartic_size> degree_of{0, 1, 1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4};
Eigen::Matrix<double, quartic_size, 1> monomials(double x, double y);

/// A height and its derivatives.
struct Height {
  double z, x, y, xx, xy, yy;
};

/// A height function of degree four over the plane through `base` with unit vectors u, v and normal n = u x v: a 4-jet.
/// `c`: of 1, x, y, x^2, xy, y^2, x^3, x^2 y, ..., y^4, in the units of the input.
struct Quartic {
  Vec3 base, u, v, n;
  std::array<double, quartic_size> c{};

  /// The height over a point of the plane, with its derivatives.
  Height at(double x, double y) const;
  /// Height of a point of space above the surface, along n.
  double above(const Vec3& point) const;
  /// Unit normal of the surface above the base.
  Vec3 normal() const;
};

}  // namespace geodrome
