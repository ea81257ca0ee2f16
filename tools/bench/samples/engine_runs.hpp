// SPDX-License-Identifier: MIT
#pragma once

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
};

/// The known variants of a choice of stages: default, none (decimator_none), insert and printed (query rules).
std::vector<Variant> variants_of(const StageChoice& stages);

/// Distances from the task's sources to their targets by `run_distances`, through files in a temporary folder: the path
/// of the product itself, which computes those to all points. Errors: those of the engine.
std::vector<std::vector<double>> engine_distances(const ManifoldTask& task, const Variant& variant,
                                                  RunSettings settings);

}  // namespace geodrome::bench
