// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/reconstructor_delaunay_cut/gaps.hpp"

namespace geodrome {

/// The surface of one piece of the sample, and what it took. Points are indices into the piece.
struct PieceSurface {
  std::vector<Triangle> faces;
  std::vector<double> feature_size;  ///< per point; +inf where unknown
  std::vector<Index> repaired;       ///< points around which cells changed sides, ascending
  std::vector<Index> unresolved;     ///< points where the border is no manifold all the same
  std::vector<Gap> gaps;
  std::size_t flips = 0, rounds = 0, bubble_faces = 0;
};

/// Labels the tetrahedra of a piece and repairs their border, which `faces` are: counter-clockwise from outside,
/// closed, lids included. Normals that the border contradicts are turned, and the labelling is done again, up to 4
/// times. No faces if the points lie in a plane. O(n log n) typically.
PieceSurface cut_piece(OrientedPiece piece, const PlanarStars& stars, RunContext& context);

}  // namespace geodrome
