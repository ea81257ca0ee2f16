// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geodrome/surface.hpp"

#include "plugins/reconstructor_delaunay_cut/labelling.hpp"

namespace geodrome {

/// What is done where the closed surface of a cut spans a hole of the sample.
enum class BoundaryRule { automatic, closed, open };

/// Faces that close holes of the sample, and points around them.
struct Lids {
  std::vector<Index> faces;  ///< ascending
  std::vector<Index> places; ///< points at their rims, ascending
  std::size_t count = 0;     ///< connected groups
};

/// Connected groups of faces that psi does not explain (planar_triangles.hpp: FaceRule). Under `open` each is a lid.
/// Otherwise a group is one if the sample itself shows a hole there: TODO
Lids find_lids(const std::vector<Triangle>& faces, const OrientedPiece& piece, const PlanarStars& stars,
               BoundaryRule rule);

/// The faces without the lids, by deleting them from a half-edge mesh; faces that then meet the rest in single points
/// only are deleted too.
std::vector<Triangle> without(const std::vector<Triangle>& faces, const Lids& lids, std::size_t point_count);

}  // namespace geodrome
