// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geodrome/errors.hpp"
#include "tools/bench/samples/lemma22.hpp"
#include "tools/bench/samples/manifold_task.hpp"
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

TEST(ManifoldEpsilon, IsRefusedWhereTheFeatureSizeIsNotKnown) {
  EXPECT_THROW(manifold_epsilon("genus2", {}, 1), OptionError);
}

TEST(ManifoldEpsilon, FallsWithTheSpacingOfTheSample) {
  const auto of = [](std::size_t points) {
    return manifold_epsilon("trefoil", shapes::sample("trefoil", {.points = points}), 1);
  };
  EXPECT_NEAR(of(2000) / of(32000), 4, 1);
}

}  // namespace
}  // namespace geodrome::bench
