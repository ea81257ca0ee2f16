// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geodrome/surface.hpp"
#include "plugins/common/points/planar_stars.hpp"
#include "plugins/reconstructor_delaunay_cut/tetrahedra.hpp"

namespace geodrome {

/// One piece of the sample: points, their outward normals, psi, and which of the stars is whose.
struct OrientedPiece {
  std::vector<Vec3> points, normals;
  std::vector<double> psi;
  std::vector<Index> kept;  ///< index of each point among the kept ones
};

/// What a labelling of the cells as inside or outside costs, in whole numbers, so that sums are exact and the cheapest
/// labelling does not depend on the order of anything.
struct CutCosts {
  std::vector<std::int32_t> inside;               ///< cost of labelling a cell inside; negative where it should be
  std::vector<std::array<std::uint16_t, 4>> cut;  ///< cost of a facet between two labels
};

/// The sides that the oriented tangent planes give, and which facets the stars have.
///
/// A cell's score is the mean over its corners p of (c - p).n / |c - p| with c its centroid: towards 1 outside, towards
/// -1 inside, 0 where it is too flat to be on a side; what is nearer to 0 than 0.3 counts as 0. A facet that 3, 2, 1, 0
/// of its corners' stars have costs 0, 0.1, 0.2, 0.4 if it is cut, and moves the scores of its two cells apart by 0.6,
/// 0.3, 0.1, 0 each, if its corners' normals agree which of them is outside: a facet that all stars have is a face, and
/// flat cells beside it must not cover it.
CutCosts cut_costs(const Tetrahedra& tetrahedra, const OrientedPiece& piece, const PlanarStars& stars);

/// 1 for cells inside, 0 for cells outside; infinite cells are outside.
using Labels = std::vector<std::uint8_t>;

/// The cheapest labelling, by a minimal cut (Boykov and Kolmogorov 2004); of several, the one with most cells inside.
Labels cheapest_labels(const Tetrahedra& tetrahedra, const CutCosts& costs);

}  // namespace geodrome
