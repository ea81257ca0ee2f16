// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// By how much a distance `far` is longer than a way over another point allows, which is `near` away and from which
/// `way` is left: far - factor (near + way), at least 0. +inf for what is no number. An unreached `far` lies beyond
/// `limit`, the search's; an unreached `near` says nothing.
inline double lipschitz_excess(double far, double near, double way, double factor, double limit) {
  if (std::isnan(far) || std::isnan(near)) return infinity;
  if (near == infinity) return 0;
  return std::max(0.0, (far == infinity ? limit : far) - factor * (near + way));
}

/// A vertex whose distance does not fit those around it, and the face where that shows.
struct MisfitVertex {
  double excess = 0;  ///< in the units of the mesh; 0: there is none
  Index vertex = no_index, face = no_index;
};

/// The vertex that is farthest away for what its neighbours say: `lipschitz_excess` over all edges, lengths weighted by
/// the face's weight. Finds a distance that is too long, or a neighbour's that is too short, by more than the edge
/// times 1 - cos of its angle to the path. O(F).
MisfitVertex worst_too_far(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit);

/// The vertex that is nearest for what its neighbours say. A shortest path reaches a vertex from a point x of the edge
/// (a, b) opposite to it in one of its faces, and x is at least as far as a and b less the way to them. Finds distances
/// that begin where no source is, beside a border as well, and those too short by more than half an edge. Vertices
/// around `sources` are left out. O(F).
MisfitVertex worst_too_near(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit,
                            std::span<const Source> sources);

/// For every face a bound of the distances of its points: the largest of a corner and the longest edge; +inf if a
/// corner is not reached. O(F).
std::vector<double> bounds_of_faces(const SurfaceMesh& mesh, std::span<const double> vertices);

}  // namespace geodrome
