// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geodrome/geometry.hpp"
#include "tools/bench/samples/sample_case.hpp"
#include "tools/bench/shapes/surface_truth.hpp"

namespace geodrome::bench {

/// The truth of a task: which mesh it starts from, and how many distances are made.
struct TruthChoice {
  std::string solver = "chen_han";
  std::size_t faces = 20'000;
  std::size_t targets = 400;  ///< a source, random
  std::size_t near = 100;     ///< more of them, random among the points that are near (see DistanceErrors)
};

/// A sample of a smooth closed shape with the true distances from some of its points to some of its points.
struct ManifoldTask {
  PointSample sample;
  std::vector<Index> sources;               ///< rows of the sample, seeded, ascending
  std::vector<std::vector<Index>> targets;  ///< per source, ascending, all the other sources among them
  std::vector<std::vector<double>> truth;   ///< per source, per target
  double hole = 0;                          ///< see `largest_hole`
  double asymmetry = 0;                     ///< largest |d(a, b) - d(b, a)| among the sources: an error of the truth
};

/// Rows of a sample, seeded, ascending, all different; all rows if there are fewer.
std::vector<Index> choose_rows(std::size_t points, std::size_t count, std::uint64_t seed);

/// The largest distance of 100,000 random points of a shape from a sample of it: a lower bound, close to it, of the
/// largest of all points. Over the local feature size, where that is the same everywhere, it is the least epsilon of
/// Definition 1.
double largest_hole(const std::string& shape, const PointSample& sample, std::uint64_t seed);

/// That epsilon. Throws OptionError for a shape without `feature_size`.
double manifold_epsilon(const std::string& shape, const PointSample& sample, std::uint64_t seed);

/// Of rows to all points the values at the task's targets.
std::vector<std::vector<double>> at_targets(const ManifoldTask& task, const std::vector<std::vector<double>>& rows);

/// Tasks on one shape.
class TaskMaker {
 public:
  /// Throws OptionError for a shape that is not in `smooth_shapes`.
  TaskMaker(const std::string& shape, const TruthChoice& choice, const PluginHost& host);

  /// A sample of the shape and the distances of as many sources. The same numbers, the same task. Noise is along the
  /// normal: the distances are those of the points before it. Precondition: the case is of this shape, without
  /// outliers. Throws OptionError for an unknown sampling, or one whose points leave the shape.
  ManifoldTask make(const SampleCase& wanted, std::size_t sources);

 private:
  std::vector<Index> targets_of(const ManifoldTask& task, std::span<const Vec3> feet, Index source,
                                std::uint64_t seed) const;

  TruthChoice choice_;
  SurfaceTruth truth_;
};

}  // namespace geodrome::bench
