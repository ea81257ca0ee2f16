// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/reconstructor_delaunay_cut/labelling.hpp"

namespace geodrome {

/// An estimate of the local feature size at every point of a piece: its distance from the nearest pole, the farthest
/// Voronoi vertex inside and the farthest outside of a point (Amenta and Bern 1999), which lie near the medial axis.
/// +inf where there are no poles. Too small where noise is left. O(n log n).
std::vector<double> feature_sizes(const Tetrahedra& tetrahedra, const CellsOfPoint& cells_of, const Labels& inside,
                                  const OrientedPiece& piece);

}  // namespace geodrome
