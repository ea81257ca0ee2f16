// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "geodrome/lower_bounds.hpp"
#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

/// What the plugin tells of its intervals: l by the extension, and the middle in place of the upper end.
namespace geodrome::test {
namespace {

struct Prepared {
  Prepared(const MeshPtr& mesh, const std::string& solver) : plugin(load_solver(solver)) {
    prepared = plugin.object->prepare(mesh, context);
    search = prepared->make_search();
  }
  const ShortestPathMap& operator()(const std::vector<Source>& sources, const Request& request = {.keep = Keep::map}) {
    return search->run(sources, request, context);
  }
  const LowerBounds& bounds() const { return *plugin.extension<LowerBounds>(); }

  Plugin<ShortestPathSolver> plugin;
  QuietContext context;
  std::unique_ptr<PreparedSurface> prepared;
  std::unique_ptr<Search> search;
};

std::vector<SurfacePoint> points_of(const MeshPtr& mesh, shapes::Random& random) {
  std::vector<SurfacePoint> points;
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    if (mesh->first_half_edge(v) != no_index) points.push_back(mesh->at_vertex(v));
  for (int i = 0; i < 100; ++i) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1) * (1 - u);
    points.push_back({static_cast<Index>(random.index(mesh->face_count())), {u, v, 1 - u - v}});
  }
  return points;
}

std::vector<Source> sources_of(const MeshPtr& mesh, shapes::Random& random) {
  std::vector<Source> sources{{mesh->at_vertex(random_vertex(mesh, random))},
                              {{static_cast<Index>(random.index(mesh->face_count())), {0.2, 0.3, 0.5}}, 0.1}};
  while (mesh->vertex_at(sources[0].at) == no_index) sources[0].at = mesh->at_vertex(random_vertex(mesh, random));
  return sources;
}

/// Returns whether all intervals are empty: the run was made with exact windows.
bool expect_intervals(const MeshPtr& mesh, const std::string& delta, shapes::Random& random, const std::string& name) {
  Prepared upper(mesh, "merged_windows:delta=" + delta), middle(mesh, "merged_windows:value=middle,delta=" + delta),
      exact(mesh, "chen_han");
  const std::vector<Source> sources = sources_of(mesh, random);
  const ShortestPathMap &d = exact(sources), &high = upper(sources), &mid = middle(sources);
  for (const SurfacePoint& at : points_of(mesh, random)) {
    const double truth = d.at(at).value, l = upper.bounds().at(high, at), m = mid.at(at).value;
    const double slack = 1e-12 * (1 + (std::isfinite(truth) ? truth : 0));
    EXPECT_LE(l, truth + slack) << name;
    EXPECT_EQ(middle.bounds().at(mid, at), l) << name;
    EXPECT_EQ(mid.at(at).source, high.at(at).source) << name;
    if (!std::isfinite(truth)) {
      EXPECT_EQ(m, infinity) << name;
      EXPECT_EQ(l, infinity) << name;
      continue;
    }
    EXPECT_NEAR(m, (l + high.at(at).value) / 2, slack) << name;
    EXPECT_LE(std::abs(m - truth), std::stod(delta) / 2 * truth + slack) << name;
    EXPECT_LE(std::abs(m - truth), m - l + slack) << name;
  }
  bool exact_run = true;
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->first_half_edge(v) == no_index) continue;
    const SurfacePoint at = mesh->at_vertex(v);
    EXPECT_EQ(mid.vertices()[v], mid.at(at).value) << name;
    exact_run = exact_run && upper.bounds().at(high, at) == high.vertices()[v];
  }
  return exact_run;
}

TEST(Intervals, HoldTheTruthAndTheirMiddleIsWithinHalfOfDelta) {
  shapes::Random random(5);
  std::size_t exact_runs = 0, runs = 0;
  for (const char* delta : {"0.3", "1e-2", "1e-4", "1e-6"})
    for (const MeshPtr& mesh : random_meshes(11)) exact_runs += expect_intervals(mesh, delta, random, delta), ++runs;
  EXPECT_GT(exact_runs, 0u);
  EXPECT_LT(exact_runs, runs);
  for (const std::uint64_t seed : {3, 9, 14, 33, 61, 88, 105})
    if (const MeshPtr mesh = share(shapes::fuzz_mesh(seed).mesh); mesh->face_count() > 0 && mesh->face_count() < 2000)
      expect_intervals(mesh, "0.1", random, "fuzz " + std::to_string(seed));
}

/// A radius cuts off middles, not upper ends, and changes no bit of those within.
TEST(Intervals, TheMiddleKeepsToARadius) {
  const MeshPtr mesh = shape("jittered-torus", 2000);
  Prepared middle(mesh, "merged_windows:value=middle,delta=0.3"), upper(mesh, "merged_windows:delta=0.3");
  const std::vector<Source> sources{{mesh->at_vertex(5)}};
  const auto all = middle(sources).vertices();
  const std::vector<double> whole(all.begin(), all.end());
  const auto ends = upper(sources).vertices();
  std::size_t between = 0;
  for (const double radius : {0.4, 1.0, 1.7}) {
    const ShortestPathMap& map = middle(sources, {.radius = radius, .keep = Keep::map});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      EXPECT_EQ(map.vertices()[v], whole[v] <= radius ? whole[v] : infinity);
      const Distance at = map.at(mesh->at_vertex(v));
      EXPECT_EQ(at.reach, whole[v] <= radius ? Reach::reached : Reach::beyond_limit);
      std::vector<SurfacePoint> path;
      map.path(mesh->at_vertex(v), path);
      EXPECT_EQ(path.empty(), whole[v] > radius);
      between += whole[v] <= radius && ends[v] > radius;
    }
  }
  EXPECT_GT(between, 0u) << "middles within a radius that their upper ends exceed";
}

/// Beyond a limit the bound is the limit up to which the search is complete; a little beyond it may be less.
TEST(Intervals, EndAtTheLimit) {
  const MeshPtr mesh = shape("jittered-torus", 2000);
  Prepared run(mesh, "merged_windows:delta=0.01"), exact(mesh, "chen_han");
  const std::vector<Source> sources{{mesh->at_vertex(5)}};
  const auto truth = exact(sources).vertices();
  std::vector<double> bounds(mesh->vertex_count());
  run.bounds().of_vertices(run(sources, {.radius = 0.8}), bounds);
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    if (truth[v] > 0.8 * 1.011) {
      EXPECT_EQ(bounds[v], 0.8) << truth[v];
    }
  const SurfacePoint target = mesh->at_vertex(50);
  const ShortestPathMap& stopped = run(sources, {.targets = {&target, 1}, .stop_at_targets = true});
  const double reached = stopped.vertices()[50];
  run.bounds().of_vertices(stopped, bounds);
  std::size_t beyond = 0;
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    if (truth[v] > reached * 1.011) {
      ++beyond;
      EXPECT_EQ(bounds[v], reached) << truth[v];
    }
  EXPECT_GT(beyond, 100u);
}

TEST(Intervals, OfPointsThatWereNotKeptAreRefused) {
  const MeshPtr mesh = shape("jittered-torus", 500);
  Prepared run(mesh, "merged_windows");
  const ShortestPathMap& map = run({{mesh->at_vertex(5)}}, {});
  EXPECT_THROW(run.bounds().at(map, {7, {0.2, 0.3, 0.5}}), CapabilityError);
  EXPECT_GT(run.bounds().at(map, mesh->at_vertex(9)), 0);
}

}  // namespace
}  // namespace geodrome::test
