// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"
#include "tools/bench/samples/distance_errors.hpp"
#include "tools/bench/samples/manifold_task.hpp"

namespace geodrome::bench {

/// A sample's surface by stages 1 to 4, which several solvers share.
struct SampledSurface {
  PlacedSurface surface;
  double seconds = 0;  ///< of stages 1 to 4 and the projection of all points
};

/// Throws SampleError for a sample that a stage refuses, and for a surface that is not of the shape's topology.
SampledSurface sampled_surface(const ManifoldTask& task, const std::string& shape, const PluginHost& host,
                               const RunSettings& settings);

/// What a solver on that surface makes of a task: against the manifold's distances.
struct ManifoldRun {
  DistanceErrors errors;
  double prepare_seconds = 0, seconds = 0;  ///< a search: median over the sources
  double total_seconds = 0;                 ///< of everything: stages 1 to 4, preparation, all searches
};

/// Distances as the query rule `project` defines them, D = max(surface distance, |st|). One thread. Throws what the
/// solver throws.
ManifoldRun run_on_manifold(const Plugin<ShortestPathSolver>& solver, const SampledSurface& surface,
                            const ManifoldTask& task);

}  // namespace geodrome::bench
