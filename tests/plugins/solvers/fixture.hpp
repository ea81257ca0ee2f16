// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/shapes/random.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::test {

inline Plugin<ShortestPathSolver> load_solver(const std::string& name) {
  static const PluginHost host({GEODROME_BINARY_DIR "/lib/geodrome"});
  return host.load<ShortestPathSolver>(name);
}

/// The distances of all vertices from one vertex.
inline std::vector<double> from_vertex(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, Index source) {
  return solver.call([&](const ShortestPathSolver& s) { return distances(s, mesh, mesh->at_vertex(source)); });
}

inline MeshPtr share(SurfaceMesh mesh) { return std::make_shared<const SurfaceMesh>(std::move(mesh)); }

inline MeshPtr shape(const std::string& kind, std::size_t faces, std::uint64_t seed = 1) {
  return share(shapes::mesh(kind, faces, seed));
}

/// The mesh with every position through `map`.
template <class Map>
MeshPtr moved(const MeshPtr& mesh, Map map) {
  std::vector<Vec3> positions;
  for (const Vec3& p : mesh->positions()) positions.push_back(map(p));
  return share(SurfaceMesh(std::move(positions), {mesh->triangles().begin(), mesh->triangles().end()}));
}

/// One mesh of each sort, small, other ones for every seed: obtuse and flat triangles, saddles, borders, handles.
inline std::vector<MeshPtr> random_meshes(std::uint64_t seed) {
  shapes::Random random(seed);
  const auto stretched = [&](const MeshPtr& mesh) {
    const Vec3 scale{random.uniform(0.3, 2), random.uniform(0.3, 2), random.uniform(0.3, 2)};
    return moved(mesh, [&](const Vec3& p) { return Vec3{scale.x * p.x, scale.y * p.y, scale.z * p.z}; });
  };
  const auto roughened = [&](const MeshPtr& mesh) {
    return moved(mesh, [&](const Vec3& p) {
      return p + 0.05 * Vec3{random.normal(), random.normal(), random.normal()};
    });
  };
  return {stretched(shape("jittered-torus", 500, seed)),
          stretched(shape("noisy-sphere", 320, seed)),
          stretched(shape("bumpy", 320)),
          roughened(shape("plane", 300)),
          roughened(shape("cut-torus", 400)),
          stretched(shape("genus2", 1000))};
}

inline Index random_vertex(const MeshPtr& mesh, shapes::Random& random) {
  return static_cast<Index>(random.index(mesh->vertex_count()));
}

/// The largest |a - b| over the largest finite a; infinite if only one of a pair is finite, or one is NaN.
inline double worst_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isfinite(a[i]) != std::isfinite(b[i]) || std::isnan(a[i] + b[i])) return INFINITY;
    if (a[i] != b[i]) worst = std::max(worst, std::abs(a[i] - b[i]));
    if (std::isfinite(a[i])) largest = std::max(largest, a[i]);
  }
  return largest > 0 ? worst / largest : worst;
}

/// Each solver on its own: what it promises must not depend on how the mesh is placed, sized or numbered.
class EverySolver : public testing::TestWithParam<std::string> {
 protected:
  const Plugin<ShortestPathSolver> solver_ = load_solver(GetParam());
};

/// Solvers whose factor is 1.
class ExactSolver : public EverySolver {};

inline std::vector<std::string> every_solver() { return {"cgal", "chen_han", "edge_dijkstra", "schreiber"}; }
inline std::vector<std::string> exact_solvers() { return {"cgal", "chen_han", "schreiber"}; }
inline std::string solver_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

/// Rounding of a few hundred operations a distance, relative to the largest distance.
inline constexpr double rounding = 1e-11;

}  // namespace geodrome::test
