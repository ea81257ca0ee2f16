// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/surface.hpp"

namespace geodrome::aleksandrov {

/// A part of a surface that was cut in two, or a leaf that was not.
struct Region {
  Index parent = no_index;
  /// What a detour through the nearest portal costs at most, in the mesh's units: the largest spacing of portals along
  /// the edges of the cut.
  double detour = 0;
  /// Places where ways go from one half to the other: all vertices of both, and points on their common edges.
  std::vector<SurfacePoint> portals;
  std::vector<Index> faces;
};

/// A surface cut in two again and again by METIS, along edges of the mesh: as few of them as it finds, halves about
/// equal. Region 0 is all of it; a parent comes before its children.
class RegionTree {
 public:
  /// Portals on cut edges are at most `spacing` > 0 apart; regions of at most `leaf_faces` are leaves. May throw
  /// Cancelled. O(F log F).
  RegionTree(const SurfaceMesh& mesh, double spacing, std::size_t leaf_faces, const RunContext& context);

  const std::vector<Region>& regions() const { return regions_; }
  /// Leaf of each vertex: one of the leaves of its faces; no_index for a vertex on no face.
  const std::vector<Index>& leaf_of_vertex() const { return leaf_of_vertex_; }

 private:
  bool split(const SurfaceMesh& mesh, Index region, double spacing);

  std::vector<Region> regions_;
  std::vector<Index> leaf_of_vertex_;
};

}  // namespace geodrome::aleksandrov
