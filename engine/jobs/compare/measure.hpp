// SPDX-License-Identifier: MIT
#pragma once

#include "engine/jobs/compare/figures.hpp"
#include "engine/jobs/compare/surfaces.hpp"

namespace geodrome {

/// A solver on a surface: ready for more searches, what it cost, and the distances.
struct Measurement {
  PreparedSolver solver;
  SearchCost cost;
  DistanceRows rows;                         ///< as `distances` gives them: sources by targets, start distances added
  std::optional<IntervalFigures> certified;  ///< over all sources, if the solver states lower bounds
};

/// Prepares the surface and searches it from every source, on this thread alone.
/// `name` is told to the observer with the progress. Throws as `prepare_solver` and `check_provides`, and what the
/// solver throws.
Measurement measure(const ComparedSurface& on, const Plugin<ShortestPathSolver>& solver, const PluginHost& host,
                    const RunSettings& settings, const std::string& name, Observer& observer);

}  // namespace geodrome
