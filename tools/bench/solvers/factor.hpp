// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"

/// Whether a solver keeps the factor it states: its distances D against those d of an exact one.
namespace geodrome::bench {

struct FactorOptions {
  std::size_t sources = 3;  ///< vertices and points in faces in turn
  std::size_t points = 300;
  std::uint64_t seed = 1;  ///< chooses both
  double seconds = 600;    ///< a search that takes longer is given up
};

/// What an exact solver says, from each source, at all vertices on faces and then at points in faces.
struct ExactDistances {
  MeshPtr mesh;
  std::vector<SurfacePoint> sources, places;
  std::size_t vertices = 0;               ///< the first so many places
  std::vector<std::vector<double>> from;  ///< per source, per place
  std::vector<double> seconds;            ///< of the search, per source
};

/// Preconditions: the mesh has a face, the solver is exact. Sources and places that are no vertices are left out if the
/// solver does not provide them. Throws what the solver throws.
ExactDistances exact_distances(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh,
                               const FactorOptions& options);

/// The worst over all places. Excess is D/d - 1, where d is above rounding; a place counts as above the factor if
/// D > factor d + 1e-12 of the largest d from the source, so that rounding does not count.
struct FactorFigures {
  std::size_t places = 0, judged = 0, above = 0;  ///< judged: those that the stated factor covers
  double largest_excess = 0, mean_excess = 0;
  double shortfall = 0;  ///< largest d - D, of the largest d; +inf: D is finite and d is not
  double ratio_sum = 0;  ///< of the excesses, for the mean
  std::size_t ratios = 0;
};

/// Adds the places of one source. `judged`: the first so many are judged by the factor, all are measured.
void add_places(FactorFigures& figures, std::span<const double> exact, std::span<const double> found, double factor,
                std::size_t judged);

struct FactorResult {
  double factor = 0;  ///< stated; +inf for none, then there is nothing to break
  FactorFigures figures;
  double prepare_seconds = 0, seconds = 0, exact_seconds = 0;  ///< of a search: medians over the same sources
  std::map<std::string, double> counters;                      ///< medians over the sources

  /// Nothing is above the factor or below d: a solver without a factor promises neither.
  bool holds() const;
};

/// Sources that the solver does not provide are left out.
FactorResult judge_factor(const Plugin<ShortestPathSolver>& solver, const ExactDistances& exact,
                          const FactorOptions& options);

/// How a solver's counters and seconds grow with 1/delta, delta = factor - 1, over results on one mesh: by name, the
/// fitted exponent. Values of 0 do not count; what has fewer than two different deltas then is left out.
std::map<std::string, double> exponents_in_delta(std::span<const FactorResult> results);

}  // namespace geodrome::bench
