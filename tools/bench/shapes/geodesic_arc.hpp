// SPDX-License-Identifier: MIT
#pragma once

#include "tools/bench/shapes/level_sets.hpp"

/// Geodesics of a surface f = 0, as solutions of x'' = -(x'. Hess f x') grad f / |grad f|^2.
namespace geodrome::bench {

/// What a Jacobi field across a geodesic is at its end.
struct Jacobi {
  double value = 0, slope = 0;
};

/// A geodesic of unit speed: its ends, and the Jacobi fields of j'' = -K j that start with (j, j') = (0, 1): `turned`,
/// and with (1, 0): `moved`. Their values are positive across n x x' at both ends, n the outward normal.
struct GeodesicArc {
  double length = 0;
  Vec3 end;
  Vec3 leaving, arriving;  ///< unit tangents, both in the direction of travel
  Jacobi turned, moved;
};

/// The geodesic from a point in a tangent direction, |direction| = 1, by a Runge-Kutta-Fehlberg method of order 8;
/// error about 1e-14 of the shapes' size a unit of length.
GeodesicArc shoot(LevelSet level, const Vec3& from, const Vec3& direction, double length);

/// The geodesic between two points of the surface whose distance is well below the radii of curvature: shooting, with
/// Newton's method for direction and length. Throws NumericalError if it does not settle.
GeodesicArc connect(LevelSet level, const Vec3& from, const Vec3& to);

/// The unit normal at a point.
Vec3 normal_at(LevelSet level, const Vec3& point);

}  // namespace geodrome::bench
