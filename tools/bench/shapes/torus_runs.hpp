// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geodrome/engine/jobs.hpp"

namespace geodrome::bench {

/// A sample of the torus with the true distances from some of its points.
struct TorusTask {
  PointSample sample;
  std::vector<Index> sources;              ///< seeded, ascending
  std::vector<std::vector<double>> truth;  ///< per source, to all points
  double epsilon = 0;                      ///< see `torus_epsilon`
  double asymmetry = 0;                    ///< largest |d(a, b) - d(b, a)| among the sources: an error of the truth
};

/// Rows of a sample, seeded, ascending, all different; all rows if there are fewer.
std::vector<Index> choose_rows(std::size_t points, std::size_t count, std::uint64_t seed);

/// `points` of the torus, uniform by area. O(sources) shootings.
TorusTask make_torus_task(std::size_t points, std::size_t sources, std::uint64_t seed);

/// The largest distance of 100,000 random points of a shape from a sample of it: a lower bound, close to it, of the
/// largest of all points. Over the local feature size, where that is the same everywhere, it is the least epsilon of
/// Definition 1.
double largest_hole(const std::string& shape, const PointSample& sample, std::uint64_t seed);

/// The same over the torus's local feature size, which is 0.4 everywhere (see torus_truth.hpp).
double torus_epsilon(const PointSample& sample, std::uint64_t seed);

/// A way through the engine: its name, and how it differs from the default.
struct Variant {
  std::string name;
  StageChoice stages;
  ProjectionRule query = ProjectionRule::project;
};

/// The known variants of a choice of stages: default, none (decimator_none), insert and printed (query rules).
std::vector<Variant> variants_of(const StageChoice& stages);

/// Distances from the sources to all points by `run_distances`, through files in a temporary folder: the path of the
/// product itself. Errors: those of the engine.
std::vector<std::vector<double>> engine_distances(const TorusTask& task, const Variant& variant, RunSettings settings);

}  // namespace geodrome::bench
