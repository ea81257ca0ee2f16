// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geodrome/errors.hpp"
#include "tools/bench/samples/distance_errors.hpp"
#include "tools/bench/samples/lemma22.hpp"
#include "tools/bench/samples/manifold_task.hpp"
#include "tools/bench/solvers/mesh_truth.hpp"
#include "tools/bench/shapes/torus_runs.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

TEST(Lemma22, TheCoarserSampleCostsTheTimeOfTheExactSolver) {
  for (const std::size_t n : {2000, 32000, 1'000'000})
    EXPECT_NEAR(std::pow(static_cast<double>(coarser(n)), 19.0 / 8) / std::pow(static_cast<double>(n), 2), 1, 2e-3);
}

TEST(Lemma22, DeltaFallsWithTheSquareRootOfThePointsFromOne) {
  EXPECT_DOUBLE_EQ(delta_of(20, 1600), 0.5);
  EXPECT_DOUBLE_EQ(delta_of(20, 100), 1);
}

TEST(Lemma22, TheConstantIsTheGeometricMean) {
  const std::vector<std::size_t> points{100, 400};
  EXPECT_NEAR(epsilon_constant(points, std::vector<double>{0.5, 0.25}), 5, 1e-12);
  EXPECT_NEAR(epsilon_constant(points, std::vector<double>{0.2, 0.4}), 4, 1e-12);
}

TEST(Extrapolated, RemovesAnErrorThatFallsWithTheFaces) {
  EXPECT_NEAR(extrapolated(3 - 5.0 / 100, 3 - 5.0 / 420, 100, 420), 3, 1e-14);
}

Plugin<ShortestPathSolver> chen_han() { return PluginHost().load<ShortestPathSolver>("chen_han"); }

/// Where shooting tells the true distances, the meshes give them, and the error they state is well above theirs.
TEST(MeshTruth, OfTheTorusIsThatOfShooting) {
  const TorusTask task = make_torus_task(500, 2, 1);
  const TrueDistances truth = MeshTruth("torus", 32'000, chen_han()).distances(task.sample.points, task.sources);
  const DistanceErrors errors = distance_errors(task.truth, truth.from);
  EXPECT_LE(4 * errors.far.mean, truth.mean_error);  // measured: 1.5e-5 and 1.0e-4
  EXPECT_LT(truth.mean_error, 2e-4);
}

TEST(ManifoldEpsilon, IsRefusedWhereNoTruthIsKnown) {
  EXPECT_THROW(manifold_epsilon("genus2", {}, 1), OptionError);
  EXPECT_THROW(TaskMaker("sphere", 1000, chen_han()), OptionError);
}

TEST(ManifoldEpsilon, FallsWithTheSpacingOfTheSample) {
  const auto of = [](std::size_t points) {
    return manifold_epsilon("trefoil", shapes::sample("trefoil", {.points = points}), 1);
  };
  EXPECT_NEAR(of(2000) / of(32000), 4, 1);
}

}  // namespace
}  // namespace geodrome::bench
