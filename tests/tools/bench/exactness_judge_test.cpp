// SPDX-License-Identifier: MIT
#include "tests/plugins/solvers/fixture.hpp"
#include "tests/support/meshes.hpp"
#include "tools/bench/solvers/exactness.hpp"
#include "tools/shapes/refine.hpp"

namespace geodrome::test {
namespace {

const bench::ExactnessOptions few{.sources = 2, .points = 20};

bench::Exactness judged(const std::string& solver, const std::string& peer, const MeshPtr& mesh) {
  const Plugin<ShortestPathSolver> one = load_solver(solver), other = load_solver(peer);
  return bench::judge(one, &other, mesh, few);
}

/// Ways along edges are real paths, only longer than needed.
TEST(ExactnessJudge, FindsASolverOfLongerPathsWrong) {
  const bench::Exactness result = judged("edge_dijkstra", "cgal", shape("bumpy", 320));
  EXPECT_FALSE(result.exact());
  EXPECT_GT(result.solver_wrong, 0u);
  EXPECT_EQ(result.peer_wrong, 0u);
  EXPECT_GT(result.at_vertices, 0.01);
}

TEST(ExactnessJudge, FindsAPeerOfLongerPathsWrongByThePathsOfTheSolver) {
  const bench::Exactness result = judged("cgal", "edge_dijkstra", shape("bumpy", 320));
  EXPECT_TRUE(result.exact()) << bench::exactness_notes(result);
  EXPECT_EQ(result.solver_wrong, 0u);
  EXPECT_GT(result.peer_wrong, 0u);
  EXPECT_GT(result.peer_error, 0.01);
}

TEST(ExactnessJudge, GoesOnWithoutAPeer) {
  const bench::Exactness result = judged("chen_han", "cgal", bow_tie());
  EXPECT_NE(result.peer_silent.find("manifold"), std::string::npos);
  EXPECT_TRUE(result.exact()) << bench::exactness_notes(result);
  EXPECT_FALSE(bench::judge(load_solver("edge_dijkstra"), nullptr, shape("cut-torus", 300), few).peer_silent.empty());
}

TEST(ExactnessJudge, TellsASolverThatCannotTakeTheMesh) {
  const bench::Exactness result = judged("cgal", "chen_han", bow_tie());
  EXPECT_FALSE(result.exact());
  EXPECT_NE(result.failure.find("manifold"), std::string::npos);
}

TEST(ExactnessJudge, ComparesAFinerMeshAtTheVerticesOfTheCoarseOne) {
  const MeshPtr coarse = shape("bumpy", 320), finer = share(shapes::refine_by_points(*coarse, 900, 1));
  const Plugin<ShortestPathSolver> exact = load_solver("cgal"), graph = load_solver("edge_dijkstra");
  EXPECT_TRUE(bench::judge_refined(exact, &exact, coarse, finer, few).exact());
  EXPECT_GT(bench::judge_refined(graph, &exact, coarse, finer, few).at_vertices, 0.01);
}

}  // namespace
}  // namespace geodrome::test
