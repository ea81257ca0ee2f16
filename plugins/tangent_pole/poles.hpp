// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// Where the Voronoi cell of a point goes farthest.
struct Pole {
  enum class Kind : std::uint8_t {
    none,      ///< no usable Voronoi vertex: all tetrahedra at the point are flat, or there are none
    vertex,    ///< the farthest Voronoi vertex
    unbounded  ///< the cell has no end: the mean direction of those of its edges that have none
  };
  Kind kind = Kind::none;
  Vec3 direction;  ///< unit vector from the point, unless there is none
};

/// Tetrahedra of less volume than this times the cube of their longest edge are flat: their circumcentres are noise. On
/// lattices four points of one row or circle are cospherical and span one, whose circumcentre lies in a tangent plane.
/// A tetrahedron that a surface of curvature 1 / r spans at spacing h has some h / (6 r), so samples up to 1e9 points
/// lose nothing.
inline constexpr double flat_volume = 1e-5;

/// The poles of the Voronoi diagram of `points` (distinct), by a Delaunay tetrahedrization with exact predicates
/// (CGAL). Ties between vertices go to the lexicographically smallest, so the result depends on the points alone. O(n
/// log n) for samples of surfaces; about 500 bytes a point. Throws NumericalError if CGAL fails.
std::vector<Pole> voronoi_poles(std::span<const Vec3> points);

}  // namespace geodrome
