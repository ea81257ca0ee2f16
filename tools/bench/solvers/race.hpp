// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/bench/solvers/search_figures.hpp"

namespace geodrome::bench {

struct RaceOptions {
  std::size_t sources = 5;  ///< random vertices
  std::size_t runs = 5;     ///< of each solver from each source
  std::uint64_t seed = 1;   ///< chooses the sources
};

/// What was measured of one of the two. Times are processor seconds.
struct Lane {
  std::string name;
  std::vector<double> preparation;         ///< one per preparation
  std::vector<std::vector<double>> query;  ///< per source, per valid run
  std::vector<Figure> windows;             ///< per source
  std::size_t prepared_bytes = 0;
};

struct RaceResult {
  Lane solver, peer;
  std::size_t edges = 0;        ///< of the mesh
  std::size_t void_runs = 0;    ///< left out, because the peer took over 1.2 times its own median from that source
  double worst_difference = 0;  ///< max over vertices of |solver - peer| over the largest distance; +inf: one has none
};

/// Races two solvers on a mesh, in one thread, interleaved: from each source, in each run, one after the other, the
/// first one changing every run. A query is one search and the copy of all vertex distances; the searches are made once
/// and used again, and each has one query before the clock starts. Preparation is timed apart. Throws CapabilityError
/// if the mesh lacks what a solver needs, and what the solvers throw.
RaceResult race(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>& peer, const MeshPtr& mesh,
                const RaceOptions& options);

/// Prints medians and ratios; a ratio is peer over solver: above 1 the solver is faster. What a solver
/// does not count is "-".
void print(std::ostream& out, const RaceResult& result);

}  // namespace geodrome::bench
