// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/reconstructor_delaunay_cut/labelling.hpp"

namespace geodrome {

/// What it took to make the border between inside and outside a 2-manifold.
struct RepairRecord {
  std::size_t flips = 0;          ///< cells that changed sides
  std::vector<Index> places;      ///< points around which, ascending
  std::vector<Index> unresolved;  ///< points where the border still is none
};

/// The border between the labels is a 2-manifold exactly if around every point the cells inside hang together across
/// facets, and so do those outside. Where there are several groups of one side, the groups whose flipping costs least
/// change sides, until every point is sound. Every cell changes sides a few times at most, so this ends.
RepairRecord make_manifold(const Tetrahedra& tetrahedra, const CutCosts& costs, const CellsOfPoint& cells_of,
                           std::size_t point_count, Labels& inside);

}  // namespace geodrome
