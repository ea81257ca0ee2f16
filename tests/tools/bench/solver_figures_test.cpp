// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <sstream>

#include "engine/report/memory.hpp"
#include "tools/bench/solvers/growth.hpp"
#include "tools/bench/solvers/memory.hpp"
#include "tools/bench/solvers/repeat.hpp"
#include "tools/bench/solvers/runner.hpp"
#include "tools/bench/solvers/search_figures.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr std::size_t block = 50'000'000;

/// What all searches of a solver did.
struct Tally {
  std::atomic<std::size_t> searches = 0, queries = 0;
};

/// Counts F^1.5 windows on a mesh of F faces, and touches a block of memory where a map is to be kept.
class CountingSearch final : public Search, private ShortestPathMap {
 public:
  CountingSearch(const SurfaceMesh& mesh, Tally& tally)
      : tally_(tally),
        distances_(mesh.vertex_count()),
        counters_{{"windows_created", 7},
                  {"windows_propagated",
                   static_cast<std::uint64_t>(std::lround(std::pow(static_cast<double>(mesh.face_count()), 1.5)))},
                  {"largest_search_bytes", 3'000'000}} {
    ++tally_.searches;
  }

  const ShortestPathMap& run(std::span<const Source>, const Request& request, RunContext&) override {
    ++tally_.queries;
    if (request.keep == Keep::map) kept_.assign(block, 1);
    return *this;
  }

 private:
  std::span<const double> vertices() const override { return distances_; }
  Distance at(const SurfacePoint&) const override { return {}; }
  void path(const SurfacePoint&, std::vector<SurfacePoint>&) const override {}
  std::span<const Counter> counters() const override { return counters_; }

  Tally& tally_;
  std::vector<double> distances_;
  std::vector<Counter> counters_;
  std::vector<char> kept_;
};

class CountingSurface final : public PreparedSurface {
 public:
  CountingSurface(MeshPtr mesh, Tally& tally) : mesh_(std::move(mesh)), tally_(tally) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<CountingSearch>(*mesh_, tally_); }
  std::size_t bytes() const override { return 11; }

 private:
  MeshPtr mesh_;
  Tally& tally_;
};

class CountingSolver final : public ShortestPathSolver {
 public:
  explicit CountingSolver(Tally& tally) : tally_(tally) {}
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext&) const override {
    return std::make_unique<CountingSurface>(std::move(mesh), tally_);
  }

 private:
  Tally& tally_;
};

Plugin<ShortestPathSolver> counting_solver(Tally& tally, Needs needs = Needs::nothing,
                                           Provides provides = Provides::paths) {
  Plugin<ShortestPathSolver> plugin;
  plugin.object = std::make_shared<const CountingSolver>(tally);
  plugin.info.stage = ShortestPathSolver::stage, plugin.info.name = "counting";
  plugin.info.needs = needs, plugin.info.provides = provides;
  return plugin;
}

MeshPtr icosphere(std::size_t faces) { return std::make_shared<const SurfaceMesh>(shapes::mesh("icosphere", faces)); }

TEST(SearchFigures, AreTakenByNameAndNoneWhereNotCounted) {
  const std::vector<Counter> counters{{"largest_search_bytes", 5}, {"windows_created", 9}, {"windows_propagated", 8}};
  EXPECT_EQ(figures_of(counters).windows, 8);
  EXPECT_EQ(figures_of(counters).bytes, 5);
  EXPECT_FALSE(figures_of({}).windows);
}

TEST(SearchFigures, OneThatIsMissingMakesTheResultMissing) {
  const std::vector<Figure> known{4, 1, 9}, partly{4, std::nullopt, 9};
  EXPECT_EQ(median_figure(known), 4);
  EXPECT_EQ(largest_figure(known), 9);
  EXPECT_FALSE(median_figure(partly));
  EXPECT_FALSE(largest_figure(partly));
  EXPECT_EQ(quotient(6, 3), 2);
  EXPECT_FALSE(quotient(6, std::nullopt));
  EXPECT_FALSE(quotient(6, 0));
}

TEST(SearchFigures, ThatAreMissingOrNotFiniteArePrintedAsDash) {
  EXPECT_EQ(figure_text(1.26, 1), "1.3");
  EXPECT_EQ(figure_text(1e9, 0), "1000000000");
  EXPECT_EQ(figure_text(std::nullopt, 1), "-");
  EXPECT_EQ(figure_text(std::numeric_limits<double>::quiet_NaN(), 1), "-");
}

TEST(EdgeCount, CountsEveryEdgeOnceWhateverItsFaces) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  EXPECT_EQ(edge_count(SurfaceMesh(corners, {{0, 1, 2}})), 3u);
  EXPECT_EQ(edge_count(SurfaceMesh(corners, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})), 7u);  // three faces at one edge
  EXPECT_EQ(edge_count(*icosphere(20)), 30u);
}

TEST(SolverGrowth, FitsTheExponentOfTheWindowsOverTheRealFaces) {
  Tally tally;
  std::vector<GrowthPoint> points;
  for (const std::size_t faces : {100, 300, 1000})  // 80, 320, 1280
    points.push_back(growth_point(counting_solver(tally), icosphere(faces), {.sources = 2, .runs = 3}));
  EXPECT_EQ(points[1].faces, 320u);
  EXPECT_EQ(points[1].edges, 480u);
  EXPECT_EQ(points[1].bytes, 3e6);
  EXPECT_NEAR(*exponents_of(points).windows, 1.5, 1e-3);
  EXPECT_EQ(tally.queries, 3u * 2 * (1 + 3));  // one from each source before the clock starts
}

TEST(SolverGrowth, HasNoExponentOfOneMeshOrOfWhatIsNotCounted) {
  const std::vector<GrowthPoint> one{{80, 120, 10, 0.5, 1}};
  EXPECT_FALSE(exponents_of(one).windows);
  const std::vector<GrowthPoint> two{{80, 120, std::nullopt, 0.5, 1}, {320, 480, 10, 2.0, 1}};
  EXPECT_FALSE(exponents_of(two).windows);
  EXPECT_NEAR(*exponents_of(two).seconds, 1, 1e-12);
}

TEST(SolverGrowth, PrintsADashForWhatIsNotCounted) {
  std::ostringstream out;
  print(out, "plane", GrowthPoint{80, 120, std::nullopt, 0.5, std::nullopt});
  std::istringstream words(out.str());
  std::vector<std::string> row(std::istream_iterator<std::string>(words), {});
  EXPECT_EQ(row, (std::vector<std::string>{"plane", "80", "-", "-", "0.500000", "-", "-"}));
  out.str("");
  print(out, "plane", GrowthPoint{80, 120, 240, 0.5, 2e6});
  words = std::istringstream(out.str());
  row.assign(std::istream_iterator<std::string>(words), {});
  EXPECT_EQ(row, (std::vector<std::string>{"plane", "80", "240", "2.00", "0.500000", "2083333.3", "2.00"}));
}

TEST(SolverRepeat, KeepsOneSearchAThreadAndAsksItsFirstQueryAgain) {
  for (const unsigned threads : {1u, 3u}) {
    Tally tally;
    const RepeatTimes times = repeat(counting_solver(tally), icosphere(300), {.sources = 50, .threads = threads});
    EXPECT_EQ(tally.searches, threads);
    EXPECT_EQ(times.query.size(), 50u);
    EXPECT_LE(times.first.size(), threads);  // a late thread may find nothing left to do
    EXPECT_EQ(tally.queries, 50 + times.first.size());
  }
}

TEST(SolverRepeat, RatesAreSourcesASecondAThread) {
  RepeatTimes times;
  times.all = 2, times.query = {0.5, 0.25, 3}, times.first = {1, 1};
  EXPECT_DOUBLE_EQ(rates_of(times).total, 0.75);
  EXPECT_DOUBLE_EQ(rates_of(times).median, 2);
}

TEST(SolverMemory, SeesWhatASearchTouches) {
  if (memory_now() == 0) GTEST_SKIP() << "/proc/self/status does not tell";
  if (!reset_memory_peak()) GTEST_SKIP() << "/proc/self/clear_refs cannot be written";
  Tally tally;
  const auto solver = counting_solver(tally);
  const SearchMemory targets = search_memory(solver, icosphere(300), 0, Keep::targets);
  const SearchMemory map = search_memory(solver, icosphere(300), 0, Keep::map);
  EXPECT_LT(targets.added(), block / 2);
  EXPECT_GT(map.added(), block * 9 / 10);
  EXPECT_EQ(map.prepared, 11u);
  EXPECT_EQ(map.search, 3e6);
}

TEST(SolverMemory, OfAMapIsRefusedWhereThereIsNone) {
  Tally tally;
  EXPECT_THROW(search_memory(counting_solver(tally, Needs::nothing, Provides::nothing), icosphere(20), 0, Keep::map),
               CapabilityError);
}

TEST(SolverRunner, RefusesASurfaceThatLacksWhatTheSolverNeeds) {
  Tally tally;
  const auto open = std::make_shared<const SurfaceMesh>(shapes::mesh("plane", 20));
  EXPECT_THROW(SolverRunner(counting_solver(tally, Needs::closed), open), CapabilityError);
  EXPECT_NO_THROW(SolverRunner(counting_solver(tally, Needs::manifold | Needs::oriented), open));
}

TEST(MemoryNow, GrowsByWhatIsTouched) {
  const std::size_t before = memory_now();
  if (before == 0) GTEST_SKIP() << "/proc/self/status does not tell";
  const std::vector<char> touched(block, 1);
  EXPECT_EQ(std::accumulate(touched.begin(), touched.end(), std::size_t{0}), block);
  const std::size_t now = memory_now();
  EXPECT_GT(now, before + block * 9 / 10);
  EXPECT_GE(memory_peak(), now);
}

}  // namespace
}  // namespace geodrome::bench
