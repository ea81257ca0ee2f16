// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "engine/smooth/shortening.hpp"
#include "tests/plugins_for_tests/exact_solver.hpp"
#include "tests/support/analytic_surfaces.hpp"
#include "tests/support/geodesic_shot.hpp"
#include "tests/support/meshes.hpp"
#include "tools/shapes/meshes.hpp"

namespace geodrome::test {

using Path = std::vector<SurfacePoint>;

inline MeshPtr shared(SurfaceMesh mesh) { return std::make_shared<const SurfaceMesh>(std::move(mesh)); }

/// The vertices of a mesh put onto a shape.
template <class Shape>
MeshPtr mesh_on(const Shape& shape, const MeshPtr& mesh) {
  return mapped(mesh, [&](const Vec3& p) { return onto(shape, p); });
}

/// A mesh of about so many faces with its vertices on a shape.
template <class Shape>
MeshPtr mesh_of(const Shape& shape, std::size_t faces) {
  return mesh_on(shape, shared(shapes::icosphere(faces)));
}
inline MeshPtr mesh_of(const Torus& shape, std::size_t faces) {
  shapes::Random random(3);
  return mesh_on(shape, shared(shapes::patch_mesh(*shapes::find_patch("torus"), faces, &random)));
}

/// Exact shortest paths on a mesh.
class FlatPaths {
 public:
  explicit FlatPaths(const MeshPtr& mesh)
      : prepared_(solver().prepare(mesh, context_)), search_(prepared_->make_search()) {}

  /// The distance, and the path from `from` to `to`.
  std::pair<double, Path> find(const SurfacePoint& from, const SurfacePoint& to) {
    const Source source{from, 0};
    if (!map_ || !(from == from_)) {
      map_ = &search_->run({&source, 1}, {.keep = Keep::map}, context_);
      from_ = from;
    }
    Path path;
    map_->path(to, path);
    std::ranges::reverse(path);
    return {map_->at(to).value, path};
  }

 private:
  static const ExactSolver& solver() {
    static const ExactSolver solver;
    return solver;
  }

  QuietContext context_;
  std::unique_ptr<PreparedSurface> prepared_;
  std::unique_ptr<Search> search_;
  const ShortestPathMap* map_ = nullptr;
  SurfacePoint from_;
};

/// A shape, a mesh with its vertices on it, flat paths and what they are shortened to.
template <class Shape>
struct Measured {
  using Surface = AnalyticSurface<Shape>;

  explicit Measured(MeshPtr m, Shape s = {}, typename Surface::Deviation deviation = {}, Pose pose = {})
      : shape(s),
        mesh(std::move(m)),
        charts(mesh, std::make_shared<const Surface>(mesh, shape, std::move(deviation), pose)),
        flat(mesh),
        shortening(charts) {}

  SmoothLength shorten(const Path& path) {
    shortening.add(path);
    return shortening.run()[0];
  }
  SmoothLength between(const SurfacePoint& from, const SurfacePoint& to) { return shorten(flat.find(from, to).second); }

  Shape shape;
  MeshPtr mesh;
  SmoothCharts charts;
  FlatPaths flat;
  Shortening shortening;
};

/// Some pairs of vertices of a mesh that lie at least `apart` apart.
inline std::vector<std::pair<SurfacePoint, SurfacePoint>> vertex_pairs(const SurfaceMesh& mesh, int count,
                                                                       double apart) {
  std::mt19937_64 random(7);
  const auto vertex = [&] { return mesh.at_vertex(static_cast<Index>(random() % mesh.vertex_count())); };
  std::vector<std::pair<SurfacePoint, SurfacePoint>> pairs;
  while (static_cast<int>(pairs.size()) < count) {
    const SurfacePoint from = vertex(), to = vertex();
    if (distance(mesh.position(from), mesh.position(to)) >= apart) pairs.emplace_back(from, to);
  }
  return pairs;
}

}  // namespace geodrome::test
