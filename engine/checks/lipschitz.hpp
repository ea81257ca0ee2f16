// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// By how much a distance `far` is longer than a way over another point allows, which is `near` away and from which
/// `way` is left: far - factor (near + way), at least 0. +inf for what is no number. An unreached `far` lies beyond
/// `limit`, the search's; an unreached `near` says nothing.
inline double lipschitz_excess(double far, double near, double way, double factor, double limit) {
  if (std::isnan(far) || std::isnan(near)) return infinity;
  if (near == infinity) return 0;
  return std::max(0.0, (far == infinity ? limit : far) - factor * (near + way));
}

/// An edge along which distances differ by more than its length.
struct SteepEdge {
  double excess = 0;  ///< `lipschitz_excess`, in the units of the mesh; 0: there is none
  Index far = no_index, near = no_index, face = no_index;
};

/// The worst edge of all faces by the distances of the vertices; lengths are weighted by the face's weight. Finds any
/// distance that is too long, or too short, by more than its neighbours in the direction of a path leave open:
/// 1 - cos of the angle between path and edge, times the edge. Cannot see distances that are too short without a jump.
/// O(F).
SteepEdge steepest_edge(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit);

/// For every face a bound of the distances of its points: the largest of a corner and the longest edge; +inf if a
/// corner is not reached. O(F).
std::vector<double> bounds_of_faces(const SurfaceMesh& mesh, std::span<const double> vertices);

}  // namespace geodrome
