// SPDX-License-Identifier: MIT
// The bench of pair oracles: which pairs it takes, what it counts as wrong, when an oracle pays.
#include <gtest/gtest.h>

#include "tools/bench/solvers/pairs.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

MeshPtr plane() { return std::make_shared<const SurfaceMesh>(shapes::mesh("plane", 100)); }

Plugin<ShortestPathSolver> load(const std::string& selection) {
  return PluginHost({GEODROME_BINARY_DIR "/tests/sound_plugins"}).load<ShortestPathSolver>(selection);
}

PairFigures figures(const std::string& solver,
                    const PairOptions& options = {.pairs = 200, .sources = 10, .searches = 3}) {
  const MeshPtr mesh = plane();
  const PairSet pairs = choose_pairs(*mesh, options);
  return pair_figures(load(solver), mesh, pairs, truth_of(load("chen_han"), mesh, pairs, options), options);
}

TEST(PairSets, HoldVerticesAndInnerPointsOnBothSides) {
  const MeshPtr mesh = plane();
  const PairSet pairs = choose_pairs(*mesh, {.pairs = 100, .sources = 10});
  ASSERT_EQ(pairs.sources.size(), 10u);
  std::size_t kinds[2][2] = {};
  for (std::size_t i = 0; i < 10; ++i) {
    ASSERT_EQ(pairs.targets[i].size(), 10u);
    for (const SurfacePoint& target : pairs.targets[i])
      ++kinds[mesh->vertex_at(pairs.sources[i]) == no_index][mesh->vertex_at(target) == no_index];
  }
  for (const auto& row : kinds)
    for (const std::size_t count : row) EXPECT_EQ(count, 25u);
}

TEST(PairSets, AreTheSameForTheSameSeedAndNeverHaveMoreSourcesThanPairs) {
  const MeshPtr mesh = plane();
  EXPECT_EQ(choose_pairs(*mesh, {}).targets, choose_pairs(*mesh, {}).targets);
  EXPECT_NE(choose_pairs(*mesh, {}).targets, choose_pairs(*mesh, {.seed = 2}).targets);
  EXPECT_EQ(choose_pairs(*mesh, {.pairs = 3, .sources = 10}).sources.size(), 3u);
}

TEST(PairFigures, OfAnExactOracleHaveNoError) {
  const PairFigures exact = figures("test_pairs");
  EXPECT_TRUE(exact.sound());
  EXPECT_LT(exact.largest, 1e-12);
  EXPECT_GT(exact.compared, 150u);
  EXPECT_GT(exact.bytes, 8u * 36 * 36);
  EXPECT_GT(exact.query, 0);
}

TEST(PairFigures, MeasureTheErrorThatTheFactorAllows) {
  const PairFigures stretched = figures("test_pairs:stretch=1.25");
  EXPECT_TRUE(stretched.sound());
  EXPECT_NEAR(stretched.largest, 0.25, 1e-9);
  EXPECT_NEAR(stretched.mean, 0.25, 1e-9);
}

TEST(PairFigures, CountWhatIsWrong) {
  EXPECT_GT(figures("test_pairs:fault=short").below, 150u);
  EXPECT_EQ(figures("test_pairs:fault=away_from_itself").above, 200u);
  EXPECT_EQ(figures("test_pairs:fault=everywhere_inf").reach_differs, 200u);
}

TEST(PairFigures, AreRefusedWithoutAnOracleAndWithAnInexactPeer) {
  EXPECT_THROW(figures("chen_han"), CapabilityError);
  const MeshPtr mesh = plane();
  const PairSet pairs = choose_pairs(*mesh, {});
  EXPECT_THROW(truth_of(load("edge_dijkstra"), mesh, pairs, {}), CapabilityError);
}

TEST(PairFigures, SayAboveHowManyPairsBuildingHasPaid) {
  PairFigures oracle;
  oracle.searching = {1, 0.011}, oracle.build = 10, oracle.query = 0.001;
  EXPECT_NEAR(*pays_above(oracle), 1000, 1e-6);
  EXPECT_NEAR(*pays_above(oracle, {3, 0.005}), 2000, 1e-6) << "8 s more once, 4 ms less a pair";
  EXPECT_EQ(*pays_above(oracle, {30, 0.005}), 0) << "the peer takes longer to be prepared";
  EXPECT_FALSE(pays_above(oracle, {3, 0.0005})) << "a search is faster than a query";
}

}  // namespace
}  // namespace geodrome::bench
