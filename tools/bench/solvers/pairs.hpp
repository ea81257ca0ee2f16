// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"

namespace geodrome::bench {

struct PairOptions {
  std::size_t pairs = 10'000;
  std::size_t sources = 100;  ///< different ones, so that the peer needs few searches
  std::size_t searches = 20;  ///< of one pair each, timed
  unsigned threads = 1;       ///< of building
  std::uint64_t seed = 1;     ///< chooses the pairs
};

/// Pairs by source: `targets[i]` belong to `sources[i]`. Every other source, and every other target, is a vertex, the
/// rest lie inside faces.
struct PairSet {
  std::vector<SurfacePoint> sources;
  std::vector<std::vector<SurfacePoint>> targets;
};

/// As many sources as wanted, but no more than pairs; the targets of each are as many, so that the number of pairs may
/// be rounded down. Throws InputError if the mesh has no face.
PairSet choose_pairs(const SurfaceMesh& mesh, const PairOptions& options);

/// Seconds of getting one distance by a search.
struct SearchSeconds {
  double preparation = 0;
  double search = 0;  ///< median over sources: to one target, stopped there where the solver can
};

/// What an exact peer says of the pairs: a search each source.
struct PairTruth {
  std::string peer;
  std::vector<std::vector<double>> distances;  ///< shaped as PairSet::targets
  SearchSeconds seconds;
};

/// Throws CapabilityError unless the peer is exact and takes any points, or if the mesh lacks what it needs.
PairTruth truth_of(const Plugin<ShortestPathSolver>& peer, const MeshPtr& mesh, const PairSet& pairs,
                   const PairOptions& options);

/// What was measured of a pair oracle. Times are wall-clock seconds.
struct PairFigures {
  SearchSeconds searching;  ///< by the same solver without its oracle
  double build = 0;
  double query = 0;              ///< one pair: median over sources, of the time for all targets of a source
  std::uint64_t bytes = 0;       ///< that the oracle saves
  std::size_t compared = 0;      ///< pairs that both reach at a distance above 0
  double largest = 0, mean = 0;  ///< of D/d - 1 over these
  /// Faults: pairs above the factor where it is promised, below the truth (both by more than 1e-12 of the largest
  /// distance), and reached by one of the two alone.
  std::size_t above = 0, below = 0, reach_differs = 0;

  bool sound() const { return above == 0 && below == 0 && reach_differs == 0; }
};

/// Throws CapabilityError unless the solver provides pair_queries, or if the mesh lacks what it needs.
PairFigures pair_figures(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, const PairSet& pairs,
                         const PairTruth& truth, const PairOptions& options);

/// Above how many pairs, all of different sources, an oracle that is asked beats a search a pair: by the same solver
/// (preparing counts for neither), or by a peer that is prepared for it. 0: from the first pair; none: never.
std::optional<double> pays_above(const PairFigures& oracle);
std::optional<double> pays_above(const PairFigures& oracle, const SearchSeconds& peer);

/// A table of one row a mesh and solver.
std::string pair_names();
std::string pair_row(const PairFigures& figures, const PairTruth& truth);

}  // namespace geodrome::bench
