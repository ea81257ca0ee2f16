// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_aleksandrov/intrinsic/plane.hpp"

namespace geodrome::aleksandrov {

/// A way from one side of an edge to the other: straight to `leave` on the edge, along it to `enter`, straight on.
struct Crossing {
  double cost;
  double leave, enter;  ///< from the start of the edge
};

/// The cheapest way from `p` above an edge along the x axis to `q` below, where a unit of length costs `above`, `below`
/// and, along the edge, `along`, not more than either: refracted by Snell's law, or along the edge from one critical
/// angle to the other. The edge has no ends here.
Crossing cheapest_crossing(Point2 p, double above, Point2 q, double below, double along);

}  // namespace geodrome::aleksandrov
