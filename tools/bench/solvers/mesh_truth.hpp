// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/engine/surface_locator.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/bench/solvers/witness.hpp"

namespace geodrome::bench {

/// The limit of values whose error falls as 1/faces, from two of them (Richardson).
double extrapolated(double coarse, double fine, double coarse_faces, double fine_faces);

/// Distances on a curved surface with what is known of their error, relative, over pairs a quarter of the largest
/// distance apart.
struct TrueDistances {
  std::vector<std::vector<double>> from;  ///< per source, per point
  double mean_error = 0, largest_error = 0;
};

/// True distances on a shape of `shapes::mesh` that is smooth: exact ones on three regular meshes with vertices on the
/// surface, each with four times the faces of the one before, extrapolated. Points are where they are closest to a
/// mesh: between a smooth surface and its meshes that keeps lengths up to the square of the edges (Hildebrandt,
/// Polthier and Wardetzky 2006). Error: the difference
/// between what the first and the last two meshes give, which is the error of the former; that of the latter, which are
/// returned, is several times smaller (6.7 times, on a torus against shooting).
class MeshTruth {
 public:
  /// Precondition: the solver is exact and provides face_sources and any_point. `faces`: of the finest mesh, about.
  MeshTruth(const std::string& shape, std::size_t faces, const Plugin<ShortestPathSolver>& solver);

  TrueDistances distances(std::span<const Vec3> points, std::span<const Index> sources);

 private:
  struct Level {
    MeshPtr mesh;
    std::unique_ptr<SurfaceLocator> locator;
    std::unique_ptr<Witness> solver;
    double faces() const { return static_cast<double>(mesh->face_count()); }
  };
  static std::vector<std::vector<double>> on_level(Level& level, std::span<const Vec3> points,
                                                   std::span<const Index> sources);

  std::array<Level, 3> levels_;  ///< coarse to fine
};

}  // namespace geodrome::bench
