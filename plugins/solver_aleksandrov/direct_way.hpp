// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plugins/solver_aleksandrov/steiner_graph.hpp"

namespace geodrome::aleksandrov {

/// A straight way between two places through faces around a common vertex.
struct DirectWay {
  /// Where it crosses an edge: `x` from the start of half-edge `h` in the face it leaves, then half-edge `g`.
  struct Crossing {
    Index h, g;
    double x;
  };
  double distance = infinity;
  std::vector<Crossing> crossings;
};

/// The shortest straight way from one place to another within the faces around a corner that their faces have in
/// common; none if there is none. Two places far nearer to a vertex than its vicinity is wide are joined by nothing
/// else that keeps the factor. O(k log k) for the k faces at these corners.
DirectWay direct_way(const SteinerGraph& graph, const SurfacePoint& from, const SurfacePoint& to);

}  // namespace geodrome::aleksandrov
