// SPDX-License-Identifier: MIT
#include "tools/bench/samples/manifold_task.hpp"

#include <algorithm>
#include <utility>

#include "geodrome/errors.hpp"
#include "tools/bench/shapes/torus_runs.hpp"
#include "tools/bench/shapes/torus_truth.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr double trefoil_feature_size = 0.1;

double feature_size(const std::string& shape) {
  if (shape == "torus") return torus_feature_size;
  if (shape == "trefoil") return trefoil_feature_size;
  throw OptionError("no true distances on '" + shape + "'", "valid shapes: torus, trefoil");
}

/// The truth of the torus is good to 1e-7 of its units: what the largest asymmetry shows is taken, over the shortest of
/// the far pairs.
ManifoldTask torus_task(std::size_t points, std::size_t sources, std::uint64_t seed) {
  TorusTask task = make_torus_task(points, sources, seed);
  double largest = 0;
  for (const auto& row : task.truth) largest = std::max(largest, *std::max_element(row.begin(), row.end()));
  const double error = task.asymmetry / (0.25 * largest);
  return {std::move(task.sample), std::move(task.sources), task.epsilon, {std::move(task.truth), error, error}};
}

}  // namespace

double manifold_epsilon(const std::string& shape, const PointSample& sample, std::uint64_t seed) {
  const double size = feature_size(shape);  // first: it refuses what is not known
  return largest_hole(shape, sample, seed) / size;
}

TaskMaker::TaskMaker(std::string shape, std::size_t faces, const Plugin<ShortestPathSolver>& solver)
    : shape_(std::move(shape)) {
  feature_size(shape_);  // refuses what is not known
  if (shape_ != "torus") meshes_ = std::make_unique<MeshTruth>(shape_, faces, solver);
}

ManifoldTask TaskMaker::make(std::size_t points, std::size_t sources, std::uint64_t seed) {
  if (!meshes_) return torus_task(points, sources, seed);
  ManifoldTask task;
  task.sample = shapes::sample(shape_, {.points = points, .seed = seed});
  task.sources = choose_rows(points, sources, seed);
  task.epsilon = manifold_epsilon(shape_, task.sample, seed);
  task.truth = meshes_->distances(task.sample.points, task.sources);
  return task;
}

}  // namespace geodrome::bench
