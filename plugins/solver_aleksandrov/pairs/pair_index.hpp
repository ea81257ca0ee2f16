// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/surface.hpp"

namespace geodrome::aleksandrov {

/// What is known of a distance: it lies between the two.
struct Bounds {
  double least, most;
};

/// Distances of all vertices to the portals of the regions they are in: the first that a way from one to another must
/// pass where it leaves a region's half. A query is a minimum over what two vertices have in common.
/// Immutable; thread-safe.
class PairIndex {
 public:
  /// Searches from every portal within its region, by an exact solver. `spacing`: of portals along cut edges. Distances
  /// are kept as floats: the mean edge of the mesh should be about 1. May throw Cancelled. Memory: 4 bytes for each
  /// vertex and portal of its regions.
  PairIndex(MeshPtr mesh, double spacing, const ShortestPathSolver& exact, RunContext& context);

  /// Reads what `save` wrote. Throws InputError if it is cut off, damaged or belongs to another number of vertices.
  PairIndex(const SurfaceMesh& mesh, std::istream& in);
  void save(std::ostream& out) const;

  /// Between vertices: `most` is the length of a way up to 3e-7 of it, or infinity; `least` 0 where a way through one
  /// leaf alone may be the shortest.
  Bounds between(Index from, Index to) const;

  std::size_t bytes() const;

 private:
  /// Columns [first, last) of the rows of all vertices in a region.
  struct Columns {
    Index parent;
    std::uint32_t depth, first, last;
    double detour;
  };

  std::span<const float> row(Index vertex) const {
    return {distance_.data() + first_[vertex], distance_.data() + first_[vertex + 1]};
  }
  void check(const SurfaceMesh& mesh) const;

  std::vector<Columns> regions_;
  std::vector<Index> leaf_;           ///< of each vertex; no_index: on no face
  std::vector<std::uint64_t> first_;  ///< of each vertex, its row
  std::vector<float> distance_;       ///< rounded up
};

}  // namespace geodrome::aleksandrov
