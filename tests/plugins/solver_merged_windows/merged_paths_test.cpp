// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

/// Paths are real, so never shorter than d, and never longer than D; most are much nearer to d.
namespace geodrome::test {
namespace {

double length_of(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += norm(mesh.position(path[i]) - mesh.position(path[i - 1]));
  return length;
}

struct Run {
  explicit Run(const MeshPtr& mesh, const std::string& solver, const std::vector<Source>& sources)
      : plugin(load_solver(solver)) {
    QuietContext context;
    prepared = plugin.object->prepare(mesh, context);
    search = prepared->make_search();
    map = &search->run(sources, {.keep = Keep::map}, context);
  }
  Plugin<ShortestPathSolver> plugin;
  std::unique_ptr<PreparedSurface> prepared;
  std::unique_ptr<Search> search;
  const ShortestPathMap* map;
};

void expect_paths(const MeshPtr& mesh, double delta, shapes::Random& random) {
  const auto random_point = [&](bool corner) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1) * (1 - u);
    const SurfacePoint inside{static_cast<Index>(random.index(mesh->face_count())), {u, v, 1 - u - v}};
    return corner ? SurfacePoint{inside.face, {1, 0, 0}} : inside;
  };
  const std::vector<Source> sources{{random_point(random.index(2) == 0), 0}};
  const Run merged(mesh, "merged_windows:delta=" + std::to_string(delta), sources), exact(mesh, "chen_han", sources);
  std::vector<SurfacePoint> path;
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint at = random_point(i % 2 == 0);
    const Distance upper = merged.map->at(at), d = exact.map->at(at);
    ASSERT_EQ(upper.reach, d.reach);
    if (d.reach != Reach::reached) continue;
    ASSERT_LE(d.value, upper.value * (1 + 1e-12));
    ASSERT_LE(upper.value, (1 + delta) * d.value * (1 + 1e-12));
    merged.map->path(at, path);
    const double length = length_of(*mesh, path);
    ASSERT_LE(length, upper.value * (1 + 1e-12));
    ASSERT_GE(length, d.value * (1 - 1e-12));
  }
}

TEST(MergedWindows, PathsAreNoLongerThanTheDistance) {
  shapes::Random random(41);
  for (const double delta : {0.3, 1e-2, 1e-3}) {
    for (const MeshPtr& mesh : random_meshes(3)) expect_paths(mesh, delta, random);
    for (std::uint64_t seed = 100; seed < 130; ++seed) expect_paths(share(shapes::fuzz_mesh(seed).mesh), delta, random);
  }
}

}  // namespace
}  // namespace geodrome::test
