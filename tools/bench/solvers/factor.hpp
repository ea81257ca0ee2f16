// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/bench/solvers/factor_figures.hpp"

/// Whether a solver keeps the factor it states, and what it says of intervals and paths, beside an exact one.
namespace geodrome::bench {

struct FactorOptions {
  std::size_t sources = 4;   ///< searches: from the four kinds of `random_sources` in turn
  std::size_t points = 300;  ///< in faces, every fourth on an edge
  std::size_t paths = 10;    ///< a search: from so many vertices, and from as many points
  std::uint64_t seed = 1;    ///< chooses all of them
  double seconds = 600;      ///< a search that takes longer is given up
};

/// What an exact solver says, in each search, at all vertices on faces and then at points in faces.
struct ExactDistances {
  MeshPtr mesh;
  std::vector<std::vector<Source>> sources;  ///< per search
  std::vector<SurfacePoint> places;
  std::size_t vertices = 0;               ///< the first so many places
  std::vector<std::vector<double>> from;  ///< per search, per place
  std::vector<double> seconds;            ///< per search
};

/// Preconditions: the mesh has a face, the solver is exact. Sources and places that the solver does not provide are
/// left out. Throws what the solver throws.
ExactDistances exact_distances(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh,
                               const FactorOptions& options);

struct FactorResult {
  double factor = 0;                    ///< stated; +inf for none, then there is nothing to break
  std::size_t faces = 0, searches = 0;  ///< searches: sources that the solver takes, each asked for twice at most
  FactorFigures figures;
  BoundFigures bounds;  ///< no runs: none are stated
  PathFigures paths;
  std::string failure;                                         ///< what the solver threw
  std::string where;                                           ///< the first place that breaks a promise, for people
  double prepare_seconds = 0, seconds = 0, exact_seconds = 0;  ///< of a search: medians over the same searches
  std::map<std::string, double> counters;                      ///< medians over the searches

  /// Nothing is above the factor or below d (a solver without a factor promises neither), no interval is wrong, no
  /// path, and nothing was thrown.
  bool holds() const;
};

/// The solver twice from all sources that it provides: for distances and bounds at the places alone, which is timed,
/// and, if it traces paths and some are wanted, with all kept, whose distances and bounds are judged as well.
FactorResult judge_factor(const Plugin<ShortestPathSolver>& solver, const ExactDistances& exact,
                          const FactorOptions& options);

/// The worst of several results with one factor; faces are those of all, times and counters are left out.
FactorResult worst_of(std::span<const FactorResult> results);

/// How a solver's counters and seconds grow with 1/delta, delta = factor - 1, over results on one mesh: by name, the
/// fitted exponent. Values of 0 do not count; what has fewer than two different deltas then is left out.
std::map<std::string, double> exponents_in_delta(std::span<const FactorResult> results);

}  // namespace geodrome::bench
