// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "tools/bench/shapes/geodesic_arc.hpp"

namespace geodrome::bench {

/// A curve between two points that is shortest among its neighbours.
struct GeodesicPath {
  double length = 0;
  std::vector<Vec3> nodes;  ///< of its pieces, each a geodesic, from end to end
  double slack = 0;         ///< how much shorter one more step would make it
};

/// The geodesic that a polyline near the surface is shortened to, its ends on the surface and kept: Newton's method on
/// a broken geodesic (Milnor, Morse Theory, section 16), whose pieces are geodesics between nodes that move across it;
/// the second derivative of the length comes from Jacobi fields and is tridiagonal. At first no piece is longer than
/// `turn` over the largest normal curvature met. The ends of the result are those of the polyline to the last bit.
/// Throws NumericalError if the length does not settle.
GeodesicPath shortened(LevelSet level, std::span<const Vec3> polyline, double turn = 0.8);

/// A bound of the normal curvatures of the surface at a point: the Frobenius norm of the Hessian over |grad f|.
double curvature_bound(LevelSet level, const Vec3& point);

double length_of(std::span<const Vec3> polyline);

/// `count` + 1 points of a polyline, equal lengths apart, its ends kept.
std::vector<Vec3> resampled(std::span<const Vec3> polyline, std::size_t count);

}  // namespace geodrome::bench
