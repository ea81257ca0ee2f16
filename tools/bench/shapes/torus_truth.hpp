// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

/// True geodesic distances on the torus of `shapes::sample`: R = 1, r = 0.4, about the z axis.
namespace geodrome::bench {

inline constexpr double torus_ring = 1, torus_tube = 0.4;

/// The distance of every point of this torus from its medial axis: the core circle inside is at distance r = 0.4 of
/// all, the z axis outside at R + r cos v >= 0.6.
inline constexpr double torus_feature_size = 0.4;

/// Angles on the torus, radians: u about the axis, v about the tube, 0 farthest from the axis.
struct TorusPoint {
  double u = 0, v = 0;
};

/// The angles of the torus point closest to `p`. Precondition: p is neither on the axis nor on the core circle.
TorusPoint torus_point(const Vec3& p);
Vec3 torus_position(const TorusPoint& p);

struct ShootingOptions {
  std::size_t rays = 16384;  ///< all around; they spread by a factor of 50 along the inner equator
  double step = 0.02;        ///< arc length of one Runge-Kutta step
};

/// Geodesic distances from `source` to the targets, by shooting: geodesics start in all directions (RK4 with Clairaut's
/// integral w^2 u' = c, and with their derivatives by the starting angle: Jacobi fields); between neighbouring rays
/// and steps the exponential map is interpolated (bicubic Hermite), and inverted at every target inside, on every
/// branch; the least length counts. Error below 1e-7 (units of the torus; measured: 1e-8). Throws
/// NumericalError if no geodesic is found to a target. O(rays / step + targets); thread-safe.
std::vector<double> torus_distances(const TorusPoint& source, std::span<const TorusPoint> targets,
                                    const ShootingOptions& options = {});

}  // namespace geodrome::bench
