// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/smooth/charts.hpp"

namespace geodrome {

/// A node of a curve: where it is asked for, and what its place gains when it moves by a unit along the direction.
struct CurveNode {
  SmoothPlace place;
  std::array<double, 3> across{};
  double spacing = 0;         ///< of its face: how far apart nodes are to lie
  double expected_error = 0;  ///< of its face
};

/// Appends the nodes of a run of pieces on trusted faces: its ends, and an odd number between them, so that every
/// second one makes a curve too. They are a spacing apart at most, by the spacing of the faces that they lie in, and
/// move across the run in the planes of these. A run in the other direction has the same nodes in reverse order, but
/// for rounding, with directions of opposite sign. Precondition: the run is not empty. O(pieces + nodes).
void place_nodes(const SmoothCharts& charts, std::span<const FlatPiece> run, std::vector<CurveNode>& nodes);

}  // namespace geodrome
