// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/bench/solvers/search_figures.hpp"

namespace geodrome::bench {

/// Bytes.
struct SearchMemory {
  std::size_t before = 0;    ///< resident in the process before the surface is prepared: mesh, plugins, program
  std::size_t peak = 0;      ///< resident at most from then on
  std::size_t prepared = 0;  ///< PreparedSurface::bytes()
  Figure search;             ///< what the search says it held at most

  std::size_t added() const { return peak > before ? peak - before : 0; }
};

/// The memory of preparing a surface, one search from a vertex and the copy of all vertex distances. The peak counts
/// from the last reset: where that is not allowed it may be older. Throws CapabilityError if the mesh lacks what the
/// solver needs, or Keep::map is asked of a solver without any_point and paths; and what the solver throws.
SearchMemory search_memory(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, Index source, Keep keep);

}  // namespace geodrome::bench
