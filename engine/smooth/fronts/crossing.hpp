// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/smooth/fronts/edge_front.hpp"

/// The last piece of a shortest path: from an edge, along which the distance is known, to a point beyond it.
namespace geodrome {

/// The point that the piece leads to. `turn`: null if the gradient there is not wanted.
struct PieceEnd {
  const Vec3& position;
  const Vec3& normal;
  const std::array<Vec3, 3>* turn = nullptr;
};

/// How a shortest path crosses an edge.
struct Crossing {
  double share;                ///< of the edge
  double distance = infinity;  ///< of the point that the piece leads to; not known where the share is too far outside
  double length = 0;           ///< of the piece
  double turn = 0;             ///< by which the normal changes along it
  Vec3 gradient;               ///< of the distance, at the point that the piece leads to, if wanted
  double spread = 0;           ///< geodesic curvature of the circle at the crossing; no number where it is not seen
};

/// Finds where the path to a point crosses an edge, from a guess of the share: the least sum of the distance along the
/// edge and the piece from there. It may lie outside of [0, 1]: then the path crosses the edge beside this one. Returns
/// nothing where no path comes over the edge.
std::optional<Crossing> find_crossing(const EdgeFront& front, const PieceEnd& to, double guess);

}  // namespace geodrome
