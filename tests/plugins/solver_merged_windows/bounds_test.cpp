// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plugins/solver_merged_windows/propagation.hpp"
#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/hostile.hpp"

/// l <= d <= D <= (1 + delta) l at every vertex: what PROOF.md proves.
namespace geodrome::test {
namespace {

constexpr double deltas[] = {0.3, 0.1, 1e-2, 1e-3, 1e-5};

/// l and D of every vertex, by the numbers and in the units of the mesh.
struct Bounds {
  std::vector<double> lower, upper;
};

Bounds bounds_of(const MeshPtr& mesh, const std::vector<Source>& sources, double delta, double limit = infinity) {
  const PackedMesh surface(mesh);
  merged_windows::Propagation propagation(surface, {delta, infinity, infinity, 0});
  propagation.begin(false, std::ldexp(limit, surface.exponent()));
  for (Index i = 0; i < sources.size(); ++i)
    propagation.seed({sources[i].at, std::ldexp(sources[i].start, surface.exponent())}, i);
  const QuietContext context;
  propagation.run(context, [] { return infinity; });
  Bounds bounds{std::vector<double>(mesh->vertex_count(), infinity),
                std::vector<double>(mesh->vertex_count(), infinity)};
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    bounds.lower[surface.original_vertex(v)] = std::ldexp(propagation.lower_bound(v), -surface.exponent());
    bounds.upper[surface.original_vertex(v)] = std::ldexp(propagation.answer(v).distance, -surface.exponent());
  }
  return bounds;
}

std::vector<double> exact(const MeshPtr& mesh, const std::vector<Source>& sources) {
  const Plugin<ShortestPathSolver> solver = load_solver("chen_han");
  QuietContext context;
  const auto prepared = solver.object->prepare(mesh, context);
  const auto search = prepared->make_search();
  const auto values = search->run(sources, {}, context).vertices();
  return {values.begin(), values.end()};
}

/// One to three sources, at vertices and in faces, with and without start distances.
std::vector<Source> random_sources(const MeshPtr& mesh, shapes::Random& random) {
  std::vector<Source> sources(1 + random.index(3));
  for (Source& source : sources) {
    source.at = mesh->at_vertex(random_vertex(mesh, random));
    if (random.index(3) == 0) {
      const double u = random.uniform(0, 1), v = random.uniform(0, 1) * (1 - u);
      source.at = {static_cast<Index>(random.index(mesh->face_count())), {u, v, 1 - u - v}};
    }
    if (random.index(3) == 0) source.start = random.uniform(0, 1) * norm(mesh->positions()[0] - mesh->positions()[1]);
  }
  return sources;
}

void expect_bounds(const MeshPtr& mesh, shapes::Random& random, const std::string& name) {
  const std::vector<Source> sources = random_sources(mesh, random);
  const std::vector<double> d = exact(mesh, sources);
  double scale = 0;
  for (const double value : d) scale = std::isfinite(value) ? std::max(scale, value) : scale;
  for (const double delta : deltas) {
    const Bounds bounds = bounds_of(mesh, sources, delta);
    for (std::size_t v = 0; v < d.size(); ++v) {
      const double l = bounds.lower[v], upper = bounds.upper[v];
      if (!std::isfinite(d[v])) {
        ASSERT_EQ(upper, infinity) << name << ", vertex " << v;
        continue;
      }
      ASSERT_LE(l, d[v] + 1e-12 * scale) << name << ", vertex " << v << ", delta " << delta;
      ASSERT_GE(upper, d[v] - 1e-12 * scale) << name << ", vertex " << v << ", delta " << delta;
      ASSERT_LE(upper, (1 + delta) * l + 1e-14 * scale) << name << ", vertex " << v << ", delta " << delta;
    }
  }
}

TEST(MergedWindows, BoundTheDistanceOnRandomMeshes) {
  shapes::Random random(31);
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const MeshPtr& mesh : random_meshes(seed)) expect_bounds(mesh, random, "seed " + std::to_string(seed));
}

TEST(MergedWindows, BoundTheDistanceOnFuzzedMeshes) {
  shapes::Random random(32);
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    expect_bounds(share(shapes::fuzz_mesh(seed).mesh), random, "fuzz " + std::to_string(seed));
}

/// Where d is not beyond the limit, l and D are as good as without one; elsewhere l, or the limit if it is lower, is
/// still no more than d.
void expect_bounds_within(double limit, const MeshPtr& mesh, const std::vector<Source>& sources,
                          const std::vector<double>& d, double delta) {
  const Bounds bounds = bounds_of(mesh, sources, delta, limit);
  for (std::size_t v = 0; v < d.size(); ++v) {
    if (!std::isfinite(d[v])) continue;
    const std::string where = std::to_string(mesh->face_count()) + " faces, delta " + std::to_string(delta) +
                              ", limit " + std::to_string(limit) + ", vertex " + std::to_string(v);
    ASSERT_LE(std::min(bounds.lower[v], limit), d[v] + 1e-12 * limit) << where;
    if (d[v] > limit * (1 - 1e-12)) continue;
    ASSERT_LE(bounds.upper[v], (1 + delta) * d[v] + 1e-12 * limit) << where;
  }
}

TEST(MergedWindows, BoundTheDistanceWithinALimitAsWell) {
  shapes::Random random(34);
  for (const std::uint64_t seed : {42, 70, 89, 262, 344, 355, 884, 914, 1, 2, 3, 4, 5, 6})
    for (int draw = 0; draw < 4; ++draw) {
      const MeshPtr mesh = share(shapes::fuzz_mesh(seed).mesh);
      const std::vector<Source> sources = random_sources(mesh, random);
      const std::vector<double> d = exact(mesh, sources);
      std::vector<double> reached;
      for (const double value : d)
        if (value > 0 && std::isfinite(value)) reached.push_back(value);
      for (int i = 0; i < 8; ++i)
        expect_bounds_within(reached[random.index(reached.size())] * random.uniform(1, 1.05), mesh, sources, d,
                             std::pow(10, random.uniform(-2, 0)));
    }
}

TEST(MergedWindows, BoundTheDistanceOnHostileMeshes) {
  shapes::Random random(33);
  for (const auto& family : shapes::hostile_families()) expect_bounds(share(family.make(0, 1)), random, family.name);
}

}  // namespace
}  // namespace geodrome::test
