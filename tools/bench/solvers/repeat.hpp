// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"

namespace geodrome::bench {

struct RepeatOptions {
  std::size_t sources = 200;  ///< random vertices
  unsigned threads = 1;       ///< with a search each; 0: one per core
  std::uint64_t seed = 1;     ///< chooses the sources
};

/// Wall-clock seconds; of what every thread has, one figure a thread.
struct RepeatTimes {
  double preparation = 0;
  double all = 0;                          ///< from the first query to the end of the last
  std::vector<double> query;               ///< one a source, in no order
  std::vector<double> making;              ///< of the search
  std::vector<double> first, first_again;  ///< the first query of a search, and the same one after all others
};

/// Queries from all sources, each a search and the copy of all vertex distances. A thread keeps one search from its
/// first query to its last and takes the next source whenever it is done. Throws CapabilityError if the mesh lacks what
/// the solver needs, and what the solver throws.
RepeatTimes repeat(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, const RepeatOptions& options);

/// Sources a second, divided by the number of threads.
struct RepeatRates {
  double total = 0;   ///< over all queries, first ones included
  double median = 0;  ///< of the median query
};
RepeatRates rates_of(const RepeatTimes& times);

void print(std::ostream& out, const std::string& name, const RepeatTimes& times);

}  // namespace geodrome::bench
