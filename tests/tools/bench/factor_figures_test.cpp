// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/factor_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome::bench {
namespace {

FactorFigures figures_of_one(const std::vector<double>& exact, const std::vector<double>& found, double factor) {
  FactorFigures figures;
  add_places(figures, exact, found, factor, found.size());
  return figures;
}

TEST(FactorFigures, MeasureTheExcessOverAllPlacesAboveZero) {
  const FactorFigures figures = figures_of_one({0, 1, 2}, {0, 1.1, 2.1}, 1.1);
  EXPECT_EQ(figures.places, 3u);
  EXPECT_NEAR(figures.largest_excess, 0.1, 1e-12);
  EXPECT_NEAR(figures.mean_excess, 0.075, 1e-12);
  EXPECT_EQ(figures.above, 0u);
  EXPECT_EQ(figures.shortfall, 0);
}

TEST(FactorFigures, CountWhatIsAboveTheFactorButNotItsRounding) {
  EXPECT_EQ(figures_of_one({1, 2}, {1.1 + 1e-12, 2}, 1.1).above, 0u);
  EXPECT_EQ(figures_of_one({1, 2}, {1.1 + 1e-11, 2}, 1.1).above, 1u);
  EXPECT_EQ(figures_of_one({0, 2}, {1e-9, 2}, 1.1).above, 1u);
}

TEST(FactorFigures, ShortfallIsAShareOfTheLargestDistance) {
  EXPECT_NEAR(figures_of_one({1, 4}, {0.9, 4}, 1.1).shortfall, 0.025, 1e-12);
}

TEST(FactorFigures, TakeUnreachableForRightWhereBothSaySo) {
  EXPECT_EQ(figures_of_one({1, infinity}, {1, infinity}, 1).above, 0u);
  EXPECT_EQ(figures_of_one({1, 2}, {1, infinity}, 1).above, 1u);
  EXPECT_EQ(figures_of_one({1, infinity}, {1, 2}, 1).shortfall, infinity);
}

TEST(FactorFigures, OfWhatIsNoNumberAreBroken) {
  const FactorFigures figures = figures_of_one({1, 2}, {1, std::nan("")}, 1.5);
  EXPECT_EQ(figures.above, 1u);
  EXPECT_EQ(figures.shortfall, infinity);
}

TEST(FactorFigures, JudgeOnlyThePlacesThatTheFactorCovers) {
  FactorFigures figures;
  add_places(figures, std::vector<double>{1, 1}, std::vector<double>{1, 3}, 1.1, 1);
  EXPECT_EQ(figures.judged, 1u);
  EXPECT_EQ(figures.above, 0u);
  EXPECT_NEAR(figures.largest_excess, 2, 1e-12);
}

TEST(FactorFigures, WithoutAFactorNothingIsAbove) { EXPECT_EQ(figures_of_one({0, 1}, {0, 9}, infinity).above, 0u); }

BoundFigures bounds_of_one(const std::vector<double>& exact, const std::vector<double>& found,
                           const std::vector<double>& bounds, double factor) {
  BoundFigures figures;
  const FirstBroken first = add_bounds(figures, exact, found, bounds, factor, found.size());
  EXPECT_EQ(first.has_value(), figures.broken() > 0);
  return figures;
}

TEST(FactorFigures, NameTheFirstPlaceThatIsAboveOrShort) {
  FactorFigures figures;
  const std::vector<double> exact{1, 2, 3, 4};
  EXPECT_EQ(add_places(figures, exact, std::vector<double>{1, 2, 3, 4}, 1.1, 4), std::nullopt);
  EXPECT_EQ(add_places(figures, exact, std::vector<double>{1, 2.3, 3.5, 4}, 1.1, 4), 1u);
  EXPECT_EQ(add_places(figures, exact, std::vector<double>{1, 2, 2.9, 4}, 1.1, 4), 2u);
  EXPECT_EQ(add_places(figures, exact, std::vector<double>{1, 2.3, 2.9, 4}, infinity, 4), std::nullopt);
  EXPECT_EQ(figures.places, 16u);
}

TEST(FactorFigures, AddUpToThoseOfAllPlaces) {
  FactorFigures together;
  add_places(together, std::vector<double>{1, 1}, std::vector<double>{1.2, 0.9}, 1.1, 2);
  add_places(together, std::vector<double>{2}, std::vector<double>{2.1}, 1.1, 1);
  FactorFigures sum = figures_of_one({1, 1}, {1.2, 0.9}, 1.1);
  sum.add({});
  sum.add(figures_of_one({2}, {2.1}, 1.1));
  EXPECT_EQ(sum.places, 3u);
  EXPECT_EQ(sum.above, 1u);
  EXPECT_EQ(sum.largest_excess, together.largest_excess);
  EXPECT_EQ(sum.mean_excess, together.mean_excess);
  EXPECT_NEAR(sum.shortfall, 0.1, 1e-12);
}

TEST(BoundFigures, HoldWhereTheTruthIsInTheIntervalAndTheWidthWithinTheFactor) {
  const BoundFigures figures = bounds_of_one({0, 1, 2}, {0, 1.05, 2}, {0, 0.98, 1.9}, 1.1);
  EXPECT_EQ(figures.broken(), 0u);
  EXPECT_NEAR(figures.largest_width, 1.05 / 0.98 - 1, 1e-12);
  EXPECT_EQ(figures.widths, 2u);
  EXPECT_EQ(figures.largest_over, 0);
}

TEST(BoundFigures, CountBoundsThatAreTooLongButNotTheirRounding) {
  EXPECT_EQ(bounds_of_one({1, 2}, {1.05, 2}, {1 + 1e-12, 2}, 1.1).broken(), 0u);
  const BoundFigures figures = bounds_of_one({1, 2}, {1.05, 2}, {1 + 1e-11, 2}, 1.1);
  EXPECT_EQ(figures.too_long, 1u);
  EXPECT_NEAR(figures.largest_excess, 1e-11, 1e-15);
  EXPECT_NEAR(figures.largest_over, 5e-12, 1e-15);
}

TEST(BoundFigures, CountIntervalsWiderThanTheFactor) {
  EXPECT_EQ(bounds_of_one({1, 2}, {1.05, 2}, {0.95, 2}, 1.1).too_wide, 1u);
  EXPECT_EQ(bounds_of_one({1, 2}, {1.05, 2}, {0.95, 2}, infinity).broken(), 0u);
}

/// A middle may be short, by no more than the way to its lower bound.
TEST(BoundFigures, CountTruthsBesideTheInterval) {
  EXPECT_EQ(bounds_of_one({1.2, 2}, {1.1, 2}, {1, 2}, infinity).beside, 0u);
  EXPECT_EQ(bounds_of_one({1.25, 2}, {1.1, 2}, {1, 2}, infinity).beside, 1u);
  EXPECT_EQ(bounds_of_one({1, 2}, {1, 2}, {1, 2.5}, infinity).beside, 1u) << "l > D";
}

TEST(BoundFigures, WithoutAPathAreInfinite) {
  EXPECT_EQ(bounds_of_one({1, infinity}, {1, infinity}, {1, infinity}, 1.1).broken(), 0u);
  EXPECT_EQ(bounds_of_one({1, infinity}, {1, infinity}, {1, 7}, infinity).beside, 1u);
  EXPECT_EQ(bounds_of_one({1, 2}, {1, 2}, {1, infinity}, 1.1).too_long, 1u);
}

TEST(BoundFigures, OfWhatIsNoNumberAreBroken) {
  const BoundFigures figures = bounds_of_one({1, 2}, {1, 2}, {1, NAN}, 1.1);
  EXPECT_EQ(figures.too_long, 1u);
  EXPECT_EQ(figures.largest_over, infinity);
}

TEST(BoundFigures, TellRunsWhoseIntervalsAreAllEmpty) {
  EXPECT_EQ(bounds_of_one({1, infinity}, {1, infinity}, {1, infinity}, 1.1).empty_runs, 1u);
  BoundFigures figures = bounds_of_one({1, 2}, {1, 2}, {1, 1.95}, 1.1);
  EXPECT_EQ(figures.empty_runs, 0u);
  figures.add(bounds_of_one({1}, {1}, {1}, 1.1));
  EXPECT_EQ(figures.empty_runs, 1u);
  EXPECT_EQ(figures.runs, 2u);
}

PathFigures paths_of_one(const std::vector<double>& exact, const std::vector<double>& found,
                         const std::vector<double>& lengths, double factor) {
  PathFigures figures;
  std::vector<MeasuredPath> measured;
  for (const double length : lengths) measured.push_back({length, 0});
  const FirstBroken first = add_paths(figures, exact, found, measured, factor, 2);
  EXPECT_EQ(first.has_value(), figures.broken() > 0);
  return figures;
}

TEST(PathFigures, HoldBetweenTheTruthAndTheDistance) {
  const PathFigures figures = paths_of_one({0, 1, 2}, {0, 1.1, 2.2}, {0, 1.05, 2.2}, 1.1);
  EXPECT_EQ(figures.broken(), 0u);
  EXPECT_NEAR(figures.largest_excess, 0.1, 1e-12);
  EXPECT_NEAR(figures.excess_sum, 0.15, 1e-12);
  EXPECT_EQ(figures.largest_detour, 0);
}

TEST(PathFigures, CountPathsShorterThanTheTruthButNotTheirRounding) {
  EXPECT_EQ(paths_of_one({1}, {1}, {1 - 1e-12}, 1.1).too_short, 0u);
  const PathFigures figures = paths_of_one({1}, {1}, {1 - 1e-11}, infinity);
  EXPECT_EQ(figures.too_short, 1u);
  EXPECT_NEAR(figures.largest_short, 5e-12, 1e-15);
}

TEST(PathFigures, CountPathsLongerThanADistanceThatHasAFactor) {
  EXPECT_EQ(paths_of_one({1}, {1.05}, {1.05 + 1e-12}, 1.1).too_long, 0u);
  EXPECT_EQ(paths_of_one({1}, {1.05}, {1.05 + 1e-11}, 1.1).too_long, 1u);
  EXPECT_EQ(paths_of_one({1}, {1.05}, {1.2}, infinity).too_long, 0u);
}

TEST(PathFigures, CountWhatTheEndsMiss) {
  const std::vector<double> one{1};
  PathFigures figures;
  EXPECT_TRUE(add_paths(figures, one, one, std::vector<MeasuredPath>{{0.9, 0.1}}, 1.1, 1));
  EXPECT_EQ(figures.too_short, 1u);
  EXPECT_TRUE(add_paths(figures, one, one, std::vector<MeasuredPath>{{1, 0.1}}, 1.1, 1));
  EXPECT_EQ(figures.too_long, 1u);
}

TEST(PathFigures, CountPathsThatLeaveTheSurface) {
  EXPECT_EQ(paths_of_one({1}, {1}, {infinity}, infinity).too_long, 1u);
  EXPECT_EQ(paths_of_one({1}, {1}, {NAN}, 1.1).broken(), 2u);
}

}  // namespace
}  // namespace geodrome::bench
