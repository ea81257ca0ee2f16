// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome::cgal {

/// The half-edges, one an edge, that CGAL's search must not meet. Where distances of both ends of an edge are the same
/// numbers, each end takes over from the other as the start of new windows, and the windows that one came from are
/// freed while they are in use. So listed are edges whose length is lost beside `longest`, a bound of all distances,
/// and whose ends both start windows: vertices of a boundary or of a total angle of 2 pi or more. `rounding`: the share
/// of `longest` up to which a length counts as lost. The mesh is manifold. O(F).
std::vector<Index> edges_without_length(const SurfaceMesh& mesh, double rounding);

/// Throws CapabilityError if there are any, naming their number and the faces at the first.
void require_lengths(const SurfaceMesh& mesh, double rounding);

/// Half a unit in the last place: d + length = d for lengths up to this share of d.
inline constexpr double lost_share = 0x1p-53;

/// Returns `call()`, which uses CGAL, unless the mesh has such edges.
template <class Call>
decltype(auto) with_lengths(const SurfaceMesh& mesh, double rounding, Call&& call) {
  require_lengths(mesh, rounding);
  return std::forward<Call>(call)();
}

}  // namespace geodrome::cgal
