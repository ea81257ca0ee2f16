// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tools/bench/solvers/factor.hpp"
#include "tools/bench/solvers/list.hpp"

namespace geodrome::bench {
namespace {

using List = std::vector<std::string>;

TEST(FactorResult, WithoutAFactorHasNothingToBreak) {
  FactorResult result{.factor = 1.5};
  EXPECT_TRUE(result.holds());
  result.figures.shortfall = 1e-3;
  EXPECT_FALSE(result.holds());
  result.factor = infinity;
  EXPECT_TRUE(result.holds());
}

TEST(ExponentsInDelta, AreFittedToSecondsAndCountersOverOneOverDelta) {
  std::vector<FactorResult> results;
  for (const double delta : {0.5, 0.1, 0.02}) {
    FactorResult& result = results.emplace_back();
    result.factor = 1 + delta, result.seconds = 2 / delta;
    result.counters = {{"Steiner points", 100 / std::sqrt(delta)}, {"none", 0}};
  }
  const auto exponents = exponents_in_delta(results);
  EXPECT_NEAR(exponents.at("seconds"), 1, 1e-9);
  EXPECT_NEAR(exponents.at("Steiner points"), 0.5, 1e-9);
  EXPECT_FALSE(exponents.contains("none"));
}

TEST(ExponentsInDelta, OfOneDeltaOrOfExactSolversAreNone) {
  const std::vector<FactorResult> results{{.factor = 1, .seconds = 1}, {.factor = 1.1, .seconds = 2}};
  EXPECT_TRUE(exponents_in_delta(results).empty());
}

TEST(SolverList, KeepsTheOptionsOfASolverTogether) {
  EXPECT_EQ(split_solvers("a:delta=0.1,placement=thin,b,c:k=v"), (List{"a:delta=0.1,placement=thin", "b", "c:k=v"}));
  EXPECT_EQ(split_solvers("a"), List{"a"});
  EXPECT_TRUE(split_solvers("").empty());
}

TEST(SolverList, SolversThatDifferByOneOptionShareTheRest) {
  EXPECT_EQ(without_option("a:delta=0.1", "delta"), "a");
  EXPECT_EQ(without_option("a:delta=0.1,k=v", "delta"), "a:k=v");
  EXPECT_EQ(without_option("a:k=v,delta=0.1,l=w", "delta"), "a:k=v,l=w");
  EXPECT_EQ(without_option("a", "delta"), "a");
}

}  // namespace
}  // namespace geodrome::bench
