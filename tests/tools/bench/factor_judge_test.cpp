// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "tests/plugins_for_tests/faulty/bounded_solver.hpp"
#include "tests/support/meshes.hpp"
#include "tools/bench/solvers/factor.hpp"
#include "tools/bench/solvers/surface_points.hpp"
#include "tools/shapes/shapes.hpp"

/// What `geodrome-bench factor` finds in solvers with a planted fault each, and in those without.
namespace geodrome::test {
namespace {

using bench::FactorResult;

MeshPtr shape(const std::string& kind, std::size_t faces) {
  return std::make_shared<const SurfaceMesh>(shapes::mesh(kind, faces));
}

Plugin<ShortestPathSolver> load(const std::string& name, const std::string& folder = "lib/geodrome") {
  return PluginHost({std::string(GEODROME_BINARY_DIR "/") + folder}).load<ShortestPathSolver>(name);
}

constexpr bench::FactorOptions few{.sources = 4, .points = 40};

FactorResult judged(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh = shape("bumpy", 320),
                    const bench::FactorOptions& options = few) {
  return bench::judge_factor(solver, bench::exact_distances(load("chen_han"), mesh, options), options);
}

/// The exact solver with a fault.
template <class Fault>
Plugin<ShortestPathSolver> faulty_solver() {
  Plugin<ShortestPathSolver> solver = load("chen_han");
  solver.object = std::make_shared<faulty::FaultySolver<Fault>>();
  return solver;
}

TEST(FactorJudge, FindsNothingInSoundSolvers) {
  for (const std::string name : {"merged_windows:delta=0.1", "merged_windows:value=middle", "chen_han", "cgal"}) {
    const FactorResult result = judged(load(name));
    EXPECT_TRUE(result.holds()) << name << ": " << result.where << result.failure;
    EXPECT_EQ(result.searches, 4u) << name;
    EXPECT_EQ(result.where, "") << name;
    EXPECT_EQ(result.paths.paths, 4u * 2 * few.paths) << name;
  }
}

/// The plugin that attacks merging alone does merge; where the solver gives way to exact windows, runs are empty.
TEST(FactorJudge, TellsWhetherARunIsExact) {
  const FactorResult alone = judged(load("test_merged_alone:delta=1e-3", "tests/sound_plugins"));
  EXPECT_TRUE(alone.holds()) << alone.where << alone.failure;
  EXPECT_EQ(alone.bounds.runs, 8u);
  EXPECT_EQ(alone.bounds.empty_runs, 0u);
  EXPECT_GT(alone.counters.at("merges_done"), 0);
  const MeshPtr large = shape("jittered-torus", 20000);
  EXPECT_EQ(judged(load("merged_windows:delta=1e-6"), large).bounds.empty_runs, 8u);
}

double too_long(const Distance& distance) { return distance.value * (1 + 1e-6); }
double too_short(const Distance& distance) { return distance.value * (1 - 1e-6); }
constexpr const auto& long_bounds = faulty::bounds_by<too_long>;
constexpr const auto& short_bounds = faulty::bounds_by<too_short>;

TEST(FactorJudge, FindsBoundsThatAreTooLong) {
  Plugin<ShortestPathSolver> solver = load("chen_han");
  solver.find_extension = extensions<long_bounds>;
  const FactorResult result = judged(solver);
  EXPECT_FALSE(result.holds());
  EXPECT_GT(result.bounds.too_long, 1000u);
  EXPECT_NEAR(result.bounds.largest_excess, 1e-6, 1e-9);
  EXPECT_NE(result.where.find("the interval at"), std::string::npos) << result.where;
  EXPECT_EQ(result.figures.above, 0u);
}

TEST(FactorJudge, FindsIntervalsWiderThanTheFactor) {
  Plugin<ShortestPathSolver> solver = load("chen_han");
  solver.find_extension = extensions<short_bounds>;
  const FactorResult result = judged(solver);
  EXPECT_FALSE(result.holds());
  EXPECT_GT(result.bounds.too_wide, 1000u);
  EXPECT_EQ(result.bounds.too_long, 0u);
  solver.factor = 1.01;
  EXPECT_TRUE(judged(solver).holds());
}

TEST(FactorJudge, FindsPathsThatAreShorterThanTheDistance) {
  const FactorResult result = judged(load("faulty_short_paths", "tests/faulty_solvers"));
  EXPECT_FALSE(result.holds());
  EXPECT_GT(result.paths.too_short, 0u);
  EXPECT_EQ(result.paths.too_long, 0u);
  EXPECT_EQ(result.figures.above, 0u);
  EXPECT_NE(result.where.find("the path at"), std::string::npos) << result.where;
}

/// To the next corner and back first.
struct Detour : faulty::NoFault {
  static void path(std::vector<SurfacePoint>& path) {
    if (path.empty()) return;
    const SurfacePoint start = path.front();
    const std::size_t corner = start.b[0] == 1 ? 1 : 0;
    SurfacePoint away{start.face, {}};
    away.b[corner] = 1;
    path.insert(path.begin(), {start, away});
  }
};

TEST(FactorJudge, FindsPathsThatAreLongerThanTheDistance) {
  const FactorResult result = judged(faulty_solver<Detour>());
  EXPECT_FALSE(result.holds());
  EXPECT_GT(result.paths.too_long, 0u);
  EXPECT_EQ(result.paths.too_short, 0u);
  EXPECT_GT(result.paths.largest_detour, 1e-3);
}

enum class Kind { at_vertex, in_face, on_edge, several };

bool is_of(Kind kind, const SurfaceMesh& mesh, std::span<const Source> sources) {
  if (kind == Kind::several || sources.size() > 1) return (kind == Kind::several) == (sources.size() > 1);
  if (kind == Kind::at_vertex) return mesh.vertex_at(sources[0].at) != no_index;
  return std::ranges::count(sources[0].at.b, 0.0) == (kind == Kind::on_edge ? 1 : 0);
}

/// A little too long everywhere in searches from sources of one kind.
template <Kind kind>
struct WrongFrom : faulty::NoFault {
  static double at_vertex(const SurfaceMesh& mesh, std::span<const Source> sources, Index, double right) {
    return is_of(kind, mesh, sources) ? right * (1 + 1e-9) : right;
  }
};

template <Kind kind>
void expect_found() {
  const FactorResult result = judged(faulty_solver<WrongFrom<kind>>());
  EXPECT_FALSE(result.holds());
  EXPECT_GT(result.figures.above, 0u);
  EXPECT_NE(result.where.find("in search " + std::to_string(static_cast<int>(kind))), std::string::npos)
      << result.where;
}

TEST(FactorJudge, FindsFaultsThatOneKindOfSourcesHas) {
  expect_found<Kind::at_vertex>();
  expect_found<Kind::in_face>();
  expect_found<Kind::on_edge>();
  expect_found<Kind::several>();
}

TEST(FactorJudge, FindsStartDistancesThatCountTooMuch) {
  bench::FactorOptions more = few;
  more.sources = 12;
  const FactorResult result = judged(load("faulty_late_starts", "tests/faulty_solvers"), shape("bumpy", 320), more);
  EXPECT_FALSE(result.holds());
  EXPECT_GT(result.figures.above, 0u);
  EXPECT_EQ(result.bounds.runs, 0u);
}

/// Wrong in every other run: in those that keep all.
struct WrongWhereAllIsKept : faulty::NoFault {
  static inline int runs = 0;
  static void before_run(const SurfaceMesh&) { ++runs; }
  static double value(double right) { return runs % 2 == 0 ? 0.999 * right : right; }
};

TEST(FactorJudge, FindsFaultsOfSearchesThatKeepAll) {
  const FactorResult result = judged(faulty_solver<WrongWhereAllIsKept>());
  EXPECT_FALSE(result.holds());
  EXPECT_GT(result.figures.shortfall, 1e-4);
}

TEST(FactorJudge, TellsWhatASolverThrows) {
  const FactorResult result = judged(load("cgal"), bow_tie());
  EXPECT_FALSE(result.holds());
  EXPECT_NE(result.failure.find("manifold"), std::string::npos) << result.failure;
}

TEST(FactorJudge, AsksASolverFromTheSourcesThatItTakes) {
  Plugin<ShortestPathSolver> solver = load("chen_han");
  solver.info.provides = Provides::start_distances;
  const FactorResult result = judged(solver);
  EXPECT_TRUE(result.holds()) << result.where << result.failure;
  EXPECT_EQ(result.searches, 1u) << "one of the four is from a vertex";
  EXPECT_EQ(result.figures.places, shape("bumpy", 320)->vertex_count());
}

TEST(FactorJudge, TheWorstOfSeveralMeshesIsBrokenIfOneIs) {
  const std::vector<FactorResult> results{judged(load("chen_han")), judged(faulty_solver<Detour>())};
  const FactorResult worst = bench::worst_of(results);
  EXPECT_FALSE(worst.holds());
  EXPECT_EQ(worst.searches, 8u);
  EXPECT_EQ(worst.paths.too_long, results[1].paths.too_long);
  EXPECT_EQ(worst.figures.places, 2 * results[0].figures.places);
  EXPECT_TRUE(bench::worst_of(std::span(results).first(1)).holds());
}

TEST(RandomSources, AreOfFourKindsInTurn) {
  const MeshPtr mesh = shape("bumpy", 320);
  shapes::Random random(3);
  std::size_t in_one_face = 0, at_once = 0, later = 0;
  for (std::size_t i = 0; i < 80; ++i) {
    const std::vector<Source> sources = bench::random_sources(*mesh, i, random);
    EXPECT_TRUE(is_of(static_cast<Kind>(i % 4), *mesh, sources)) << i;
    EXPECT_EQ(sources[0].start, 0);
    for (std::size_t k = 1; k < sources.size(); ++k) {
      ++(sources[k].start > 0 ? later : at_once);
      in_one_face += sources[k].at.face == sources[k - 1].at.face;
    }
  }
  EXPECT_GT(in_one_face, 5u);
  EXPECT_GT(at_once, 5u);
  EXPECT_GT(later, at_once);
}

}  // namespace
}  // namespace geodrome::test
