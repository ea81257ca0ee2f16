// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/common/points/planar_stars.hpp"
#include "plugins/reconstructor_delaunay_cut/sheet_rule.hpp"

namespace geodrome {

/// A sheet: faces that lie side by side around every point, not oriented. Points are kept points.
struct SheetSurface {
  std::vector<Triangle> faces;
  std::vector<Index> thin;      ///< points around thin places that were closed, ascending
  std::size_t thin_places = 0;  ///< how many of these
  std::size_t pockets = 0;      ///< boundary loops shorter than `least_boundary` spacings that are left
};

/// Makes a sheet from the planar stars (the paper's union of stars, Section 2.3) of `members` without an inside or an
/// outside, which an open or one-sided sheet has not: their triangles are taken one by one, those of most corners'
/// stars first, then the smallest, and each stays that lies beside all that are there. Triangles that all corners have
/// are never in each other's way but in cocircular ties. Then notches of the rim and small loops, where stars disagree,
/// are closed from their corners; `close_thin`: also by faces that psi does not explain, if the loop is shorter than
/// `least_boundary` spacings. O(n log n).
SheetSurface sheet_surface(const SheetSample& sample, const PlanarStars& stars, std::span<const Index> members,
                           bool close_thin);

}  // namespace geodrome
