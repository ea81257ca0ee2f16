// SPDX-License-Identifier: MIT
#pragma once

#include "engine/jobs/compare/errors.hpp"
#include "engine/jobs/compare/surfaces.hpp"
#include "engine/search/smooth_distances.hpp"

namespace geodrome {

/// The distances of a solver on the smooth surface, and what they cost.
struct SmoothMeasurement {
  DistanceRows rows;                   ///< sources by targets, start distances added
  std::vector<double> source_seconds;  ///< one per source: the search, its paths and what becomes of them
  SmoothFigures paths;
};

/// Searches from every source once more, on this thread alone, and takes the paths to the smooth surface of `on`.
/// `name` is told to the observer with the progress. Throws what the solver and the surface throw. Precondition: the
/// solver, which has the mesh of `on` prepared, provides paths, and `on` has a metric.
SmoothMeasurement measure_smooth(const ComparedSurface& on, PreparedSolver solver, const RunSettings& settings,
                                 const std::string& name, Observer& observer);

}  // namespace geodrome
