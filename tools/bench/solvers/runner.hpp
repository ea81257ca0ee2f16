// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <memory>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/bench/solvers/search_figures.hpp"

namespace geodrome::bench {

/// Throws CapabilityError unless the mesh is what a solver needs.
void require_needs(const PluginInfo& solver, const SurfaceMesh& mesh);

/// Wall-clock time of a piece of work.
template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Processor time that a piece of work takes of this thread, or of another clock: what else runs counts less than in
/// wall-clock time.
template <class Work>
double processor_seconds_of(Work&& work, clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  const auto now = [clock] {
    timespec time;
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

/// One solver on a mesh, in one thread: prepared, with a search that is used again and again, and what its last query
/// gave. Times are processor seconds. Throws what the solver throws.
class SolverRunner {
 public:
  /// Throws CapabilityError if the mesh lacks what the solver needs.
  SolverRunner(Plugin<ShortestPathSolver> plugin, MeshPtr mesh);

  double prepare();
  double make_search();
  /// A search from the vertex and the copy of all vertex distances.
  double query(Index vertex, Keep keep = Keep::targets);

  /// On the same prepared surface, for another thread: with no search yet.
  SolverRunner shared() const;

  const std::vector<double>& distances() const { return distances_; }
  const SearchFigures& figures() const { return figures_; }
  std::size_t prepared_bytes() const { return prepared_->bytes(); }

 private:
  Plugin<ShortestPathSolver> plugin_;
  MeshPtr mesh_;
  QuietContext context_;
  std::shared_ptr<const PreparedSurface> prepared_;
  std::unique_ptr<Search> search_;
  std::vector<double> distances_;
  SearchFigures figures_;
};

/// Vertices that faces use, drawn with the seed; one may come twice. Throws InputError if the mesh has no face.
std::vector<Index> choose_sources(const SurfaceMesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace geodrome::bench
