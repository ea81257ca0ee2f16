// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_aleksandrov/steiner_graph.hpp"

namespace geodrome::aleksandrov {

/// The faces at a vertex of a weighted surface. Nearer than `width` the surface is a cone with weights: what is twice
/// as far from the vertex, in the same direction, costs twice as much, by the same way twice as large.
struct SourceStar {
  double width;  ///< from the vertex to the nearest of the sides opposite to it
  double reach;  ///< ways from the vertex that cost less do not leave the disc of that radius
};

/// O(degree).
SourceStar source_star(const SteinerGraph& graph, Index vertex);

/// The factor holds beyond `far_enough` of the reach; what is nearer is scaled out until it lies between that and
/// `scaled_limit` of it, by steps of `scale_step`. PROOF.md, With weights, has the proof of these numbers.
inline constexpr double far_enough = 1.0 / 8, scaled_limit = 7.0 / 16, scale_step = 1.5;
/// A way that costs more than this share of the reach is to a place beyond `far_enough`.
inline constexpr double surely_far = 1.0 / 4;

/// A place of a face moved away from its corner `i`, straight, to `scale` times the distance.
SurfacePoint scaled(const SurfacePoint& at, Index i, double scale);

}  // namespace geodrome::aleksandrov
