// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geodrome/surface.hpp"
#include "plugins/common/surfaces/finished_surface.hpp"
#include "plugins/reconstructor_delaunay_cut/labelling.hpp"

namespace geodrome {

/// A connected group of faces that psi does not explain (FaceRule), in a surface that a cut has closed.
struct Gap {
  std::vector<Index> faces;   ///< ascending
  std::vector<Index> places;  ///< the points at their corners, ascending
  bool hole = false;          ///< the sample shows a hole there
  bool disk = true;           ///< the faces form a disk; if not, they join parts of the surface that nothing else joins
};

/// The gaps of a closed surface; `faces` are corners among the points of `piece`.
///
/// The sample shows a hole where a gap has a face with a circumradius over 5 psi, at least 20 points are at its corners
/// and most of these have a planar cell that reaches over 2.5 psi or has no end: what a boundary looks like from the
/// points alone. Smaller gaps are thin places of the sample. O(F log F).
std::vector<Gap> find_gaps(const std::vector<Triangle>& faces, const OrientedPiece& piece, const PlanarStars& stars);

}  // namespace geodrome
