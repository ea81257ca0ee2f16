// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/engine/surface_locator.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/bench/shapes/broken_geodesic.hpp"
#include "tools/bench/solvers/witness.hpp"

namespace geodrome::bench {

/// True geodesic distances on a smooth shape. An exact solver's paths on a fine mesh with vertices on the shape, which
/// miss the true distances by the square of its edges, are shortened to geodesics of the shape itself (see
/// `shortened`). Near a cut locus the mesh may prefer the wrong one of two ways of nearly the same length, so that the
/// paths to points all around a target, bent to it, are shortened too where they take another way; the least
/// length counts. Error: that of the geodesics, 1e-12 of the shape's size.
class SurfaceTruth {
 public:
  /// Precondition: the solver is exact and provides face_sources, any_point and paths. `faces`: of the mesh, about.
  /// Throws OptionError for a shape that is not in `smooth_shapes`.
  SurfaceTruth(const std::string& shape, std::size_t faces, const Plugin<ShortestPathSolver>& solver);

  /// What is asked next is measured from a point of the shape.
  void start(const Vec3& source);

  /// Distances on the mesh.
  std::vector<double> rough(std::span<const Vec3> points) const;

  /// The distance of a point of the shape, 0 from the source itself. Throws NumericalError if a path does not settle,
  /// or if its length is not that of the mesh up to what the mesh can miss.
  double distance(const Vec3& target) const;

 private:
  std::vector<Vec3> rough_path(const Vec3& target) const;
  std::vector<std::vector<Vec3>> starts(const Vec3& target) const;

  LevelSet level_;
  MeshPtr mesh_;
  SurfaceLocator locator_;
  Witness solver_;
  double edge_ = 0;  ///< mean length of the mesh's edges
  Vec3 source_;
};

}  // namespace geodrome::bench
