// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/guarantee.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace geodrome {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

GuaranteeTerms terms(double factor, std::size_t targets) {
  return {.factor = factor,
          .never_shorter = true,
          .exact_truth = true,
          .of_source = {true},
          .of_target = std::vector<bool>(targets, true),
          .scale = 4,
          .tolerance = 1e-10};
}

TEST(JudgeGuarantee, HoldsBetweenTheTruthAndTheFactor) {
  const GuaranteeFigures g = judge_guarantee({{0, 1, 2.2, inf}}, {{0, 1, 2, inf}}, terms(1.125, 4));
  EXPECT_EQ(g.stated, 1.125);
  EXPECT_DOUBLE_EQ(g.worst.value(), 1.1);
  EXPECT_EQ(g.held, true);
}

TEST(JudgeGuarantee, IsBrokenAboveTheFactor) {
  const GuaranteeFigures g = judge_guarantee({{0, 1, 2.26}}, {{0, 1, 2}}, terms(1.125, 3));
  EXPECT_EQ(g.held, false);
  EXPECT_NE(g.why.find("1 distances are above the factor"), std::string::npos) << g.why;
  EXPECT_NE(g.why.find("row 2"), std::string::npos) << g.why;
}

TEST(JudgeGuarantee, IsBrokenBelowTheTruthUnlessTheSolverSaysSo) {
  GuaranteeTerms stated = terms(inf, 2);
  EXPECT_EQ(judge_guarantee({{0, 1.99}}, {{0, 2}}, stated).held, false);
  stated.never_shorter = false;
  const GuaranteeFigures g = judge_guarantee({{0, 1.99}}, {{0, 2}}, stated);
  EXPECT_EQ(g.held, std::nullopt);
  EXPECT_EQ(g.why, "the solver states nothing");
}

TEST(JudgeGuarantee, NoFactorAllowsADistanceBetweenPointsAtOnePlace) {
  const GuaranteeFigures g = judge_guarantee({{0, 0.1, 1}}, {{0, 0, 1}}, terms(1.125, 3));
  EXPECT_EQ(g.held, false);
  EXPECT_EQ(g.worst, 1);
}

TEST(JudgeGuarantee, TakesRoundingForNoError) {
  EXPECT_EQ(judge_guarantee({{1 + 1e-13}}, {{1}}, terms(1, 1)).held, true);
  EXPECT_EQ(judge_guarantee({{1 - 1e-13}}, {{1}}, terms(1, 1)).held, true);
  EXPECT_EQ(judge_guarantee({{1 + 1e-8}}, {{1}}, terms(1, 1)).held, false);
}

TEST(JudgeGuarantee, IsNotJudgedByAnotherTruth) {
  GuaranteeTerms stated = terms(1, 1);
  stated.exact_truth = false;
  const GuaranteeFigures g = judge_guarantee({{3}}, {{2}}, stated);
  EXPECT_EQ(g.held, std::nullopt);
  EXPECT_EQ(g.worst, 1.5);
  EXPECT_NE(g.why.find("not the exact distance"), std::string::npos);
}

TEST(JudgeGuarantee, CountsOnlyThePairsItIsStatedFor) {
  GuaranteeTerms stated = terms(1, 2);
  stated.of_target = {true, false};
  EXPECT_EQ(judge_guarantee({{1, 9}}, {{1, 2}}, stated).held, true);
  stated.of_source = {false};
  const GuaranteeFigures g = judge_guarantee({{1, 9}}, {{1, 2}}, stated);
  EXPECT_EQ(g.held, std::nullopt);
  EXPECT_EQ(g.worst, std::nullopt);
}

TEST(ScaleOfDistances, HoldsCoordinatesAndDistances) {
  const Vec3 corner{-7, 1, 2};
  EXPECT_EQ(scale_of({{3, inf}}, {&corner, 1}, 1), 7);
  EXPECT_EQ(scale_of({{3, inf}}, {&corner, 1}, 0.25), 3);
}

}  // namespace
}  // namespace geodrome
