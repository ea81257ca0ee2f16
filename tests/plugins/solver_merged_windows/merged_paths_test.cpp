// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_merged_windows/bounded_search.hpp"
#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

/// Paths are real, so never shorter than d, and never longer than D; most are much nearer to d. They begin at the
/// source that is named.
namespace geodrome::test {
namespace {

double length_of(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += norm(mesh.position(path[i]) - mesh.position(path[i - 1]));
  return length;
}

struct Run {
  Run(std::unique_ptr<PreparedSurface> surface, const std::vector<Source>& sources) : prepared(std::move(surface)) {
    QuietContext context;
    search = prepared->make_search();
    map = &search->run(sources, {.keep = Keep::map}, context);
  }
  std::unique_ptr<PreparedSurface> prepared;
  std::unique_ptr<Search> search;
  const ShortestPathMap* map;
};

/// With windows that stay merged, however long lists are.
Run merged_run(const MeshPtr& mesh, double delta, const std::vector<Source>& sources) {
  QuietContext context;
  const merged_windows::Settings settings{delta, infinity, infinity, 0};
  return {prepare_exact<merged_windows::Fallback, merged_windows::BoundedSearch>(mesh, settings, context), sources};
}

Run exact_run(const MeshPtr& mesh, const std::vector<Source>& sources) {
  static const Plugin<ShortestPathSolver> plugin = load_solver("chen_han");
  QuietContext context;
  return {plugin.object->prepare(mesh, context), sources};
}

SurfacePoint random_point(const MeshPtr& mesh, bool corner, shapes::Random& random) {
  const double u = random.uniform(0, 1), v = random.uniform(0, 1) * (1 - u);
  const SurfacePoint inside{static_cast<Index>(random.index(mesh->face_count())), {u, v, 1 - u - v}};
  return corner ? SurfacePoint{inside.face, {1, 0, 0}} : inside;
}

std::vector<Source> random_sources(const MeshPtr& mesh, std::size_t count, shapes::Random& random) {
  std::vector<Source> sources(count);
  for (Source& source : sources) {
    source.at = random_point(mesh, random.index(2) == 0, random);
    if (count > 1 && random.index(2) == 0)
      source.start = random.uniform(0, 3) * norm(mesh->positions()[0] - mesh->positions()[1]);
  }
  return sources;
}

/// Lengths of paths are judged with a share `rounding` for that of coordinates.
void expect_paths(const MeshPtr& mesh, double delta, std::size_t source_count, double rounding,
                  shapes::Random& random) {
  const std::vector<Source> sources = random_sources(mesh, source_count, random);
  const Run merged = merged_run(mesh, delta, sources), exact = exact_run(mesh, sources);
  std::vector<Run> alone;
  for (const Source& source : sources) alone.push_back(exact_run(mesh, {source}));
  std::vector<SurfacePoint> path;
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint at = random_point(mesh, i % 2 == 0, random);
    const Distance upper = merged.map->at(at), d = exact.map->at(at);
    ASSERT_EQ(upper.reach, d.reach);
    if (d.reach != Reach::reached) continue;
    ASSERT_LE(d.value, upper.value * (1 + 1e-12));
    ASSERT_LE(upper.value, (1 + delta) * d.value * (1 + 1e-12));
    ASSERT_LE(alone[upper.source].map->at(at).value, upper.value * (1 + 1e-12)) << "the source that is named";
    merged.map->path(at, path);
    const Source& named = sources[upper.source];
    const double length = named.start + length_of(*mesh, path);
    ASSERT_LE(length, upper.value * (1 + rounding));
    ASSERT_GE(length, d.value * (1 - rounding));
    ASSERT_EQ(norm(mesh->position(path.back()) - mesh->position(named.at)), 0);
  }
}

TEST(MergedWindows, PathsAreNoLongerThanTheDistance) {
  shapes::Random random(41);
  for (const double delta : {0.3, 1e-2, 1e-3}) {
    for (const MeshPtr& mesh : random_meshes(3)) expect_paths(mesh, delta, 1, 1e-12, random);
    for (std::uint64_t seed = 100; seed < 130; ++seed)
      expect_paths(share(shapes::fuzz_mesh(seed).mesh), delta, 1, 1e-12, random);
  }
}

/// D of a vertex may fall, and then belong to another source, though the vertex does not emit again: the windows that
/// it sent before go on by its old way. Some of these meshes are 100 extents from the origin.
TEST(MergedWindows, PathsLeadToTheSourceThatIsNamed) {
  for (const std::uint64_t seed : {160, 183, 210, 385, 1010, 1096, 1189, 1566, 1626})
    for (std::uint64_t draw = 0; draw < 4; ++draw) {
      shapes::Random random(seed + 100000 * draw);
      const double delta = random.index(2) == 0 ? 0.3 : 0.1;
      expect_paths(share(shapes::fuzz_mesh(seed).mesh), delta, 2 + random.index(3), 1e-10, random);
      if (HasFailure()) FAIL() << "fuzz:" << seed;
    }
}

}  // namespace
}  // namespace geodrome::test
