// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/jobs.hpp"
#include "tools/bench/samples/manifold_task.hpp"

namespace geodrome::bench {

/// A way through the engine: its name, and how it differs from the default.
struct Variant {
  std::string name;
  StageChoice stages;
  ProjectionRule query = ProjectionRule::project;
  Metric metric = Metric::flat;
};

/// The known variants of a choice of stages: default, none (decimator_none), insert and printed (query rules); flat.
std::vector<Variant> variants_of(const StageChoice& stages);

/// What became of the distances of a task, and what the engine says of them.
struct EngineRun {
  std::vector<std::vector<double>> distances;  ///< per source, per target
  double row_seconds = 0;                      ///< processor time a row, to all points; 0 of fewer than four rows
  std::optional<double> estimated_error;       ///< relative, mean over all rows; of the smooth metric
  std::optional<double> smooth_share;          ///< of the length of the paths, what lies on the smooth surface
};

/// Distances from the task's sources to their targets by `run_distances`, through files in a temporary folder: the path
/// of the product itself, which computes those to all points. Errors: those of the engine.
EngineRun engine_distances(const ManifoldTask& task, const Variant& variant, RunSettings settings);

}  // namespace geodrome::bench
