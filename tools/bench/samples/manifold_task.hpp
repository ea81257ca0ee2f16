// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geodrome/geometry.hpp"
#include "tools/bench/solvers/mesh_truth.hpp"

namespace geodrome::bench {

/// A sample of a smooth closed shape with the true distances from some of its points.
struct ManifoldTask {
  PointSample sample;
  std::vector<Index> sources;  ///< rows of the sample
  double epsilon = 0;          ///< see `manifold_epsilon`
  TrueDistances truth;
};

/// The least epsilon of a sample of torus or trefoil, from below (see `largest_hole`). The local feature size is the
/// radius of the tube everywhere: the core curve is that far from every point, and nothing else of the medial axis is
/// nearer; of the trefoil, strands are 0.2 from the middle between two, less the radius 0.1, and centres of curvature
/// at least 1/2.34 - 0.1. Throws OptionError for another shape.
double manifold_epsilon(const std::string& shape, const PointSample& sample, std::uint64_t seed);

/// Tasks on one shape: by shooting on the torus, by fine meshes on the trefoil.
class TaskMaker {
 public:
  /// Throws OptionError for another shape. `faces`, `solver`: of the finest mesh, see MeshTruth.
  TaskMaker(std::string shape, std::size_t faces, const Plugin<ShortestPathSolver>& solver);

  /// `points` of the shape, uniform. The same numbers, the same task.
  ManifoldTask make(std::size_t points, std::size_t sources, std::uint64_t seed);

 private:
  std::string shape_;
  std::unique_ptr<MeshTruth> meshes_;  ///< null for the torus
};

}  // namespace geodrome::bench
