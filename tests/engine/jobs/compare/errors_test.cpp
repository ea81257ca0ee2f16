// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace geodrome {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(CompareDistances, AreRelativeToTheTruthBothWays) {
  const ErrorFigures e = compare_distances({{0, 1.5, 2, 3}}, {{0, 1, 2, 4}});
  EXPECT_EQ(e.all.compared, 3u);
  EXPECT_DOUBLE_EQ(e.max_over, 0.5);
  EXPECT_DOUBLE_EQ(e.max_under, 0.25);
  EXPECT_DOUBLE_EQ(e.all.mean, 0.25);
  EXPECT_DOUBLE_EQ(e.all.max, 0.5);
}

TEST(CompareDistances, LeavesOutWhatHasNoRelativeError) {
  const ErrorFigures e = compare_distances({{0, inf, 2, nan, inf, 1}}, {{0, inf, nan, 1, 3, inf}});
  EXPECT_EQ(e.all.compared, 0u);
  EXPECT_TRUE(e.quantiles.empty());
  EXPECT_EQ(e.reach_differs, 2u);
  EXPECT_EQ(e.unreachable, 2u);
}

TEST(CompareDistances, CountAWrongZeroAsAnErrorOfOne) {
  const ErrorFigures e = compare_distances({{0, 4}}, {{1, 4}});
  EXPECT_EQ(e.max_under, 1);
  EXPECT_EQ(e.all.compared, 2u);
}

TEST(CompareDistances, PutNearAndFarPairsApartByTheLargestTrueDistance) {
  // Of 100: 4 is near, 5 and 24 are neither, 25 and 100 are far.
  const ErrorFigures e =
      compare_distances({{4 * 1.5, 5 * 1.1, 24 * 1.1}, {25 * 1.25, 100 * 1.75, inf}}, {{4, 5, 24}, {25, 100, inf}});
  EXPECT_EQ(e.near.compared, 1u);
  EXPECT_DOUBLE_EQ(e.near.mean, 0.5);
  EXPECT_EQ(e.far.compared, 2u);
  EXPECT_DOUBLE_EQ(e.far.mean, 0.5);
  EXPECT_DOUBLE_EQ(e.far.max, 0.75);
}

TEST(CompareDistances, QuantilesAreNearestRanks) {
  std::vector<double> truth(200, 1024), distances;
  for (int i = 1; i <= 200; ++i) distances.push_back(1024 + i);
  const ErrorFigures e = compare_distances({distances}, {truth});
  ASSERT_EQ(e.quantiles.size(), 4u);
  EXPECT_EQ(e.quantiles[0], 100 / 1024.0);
  EXPECT_EQ(e.quantiles[1], 180 / 1024.0);
  EXPECT_EQ(e.quantiles[2], 198 / 1024.0);
  EXPECT_EQ(e.quantiles[3], 200 / 1024.0);
}

TEST(CompareDistances, HistogramCountsEachErrorOnceInItsBin) {
  // Exact: 0, 2^-4 = 0.0625 in [10^-1.5, 10^-1), 9 in [10^0.5, 10), 99 beyond the last edge.
  const ErrorFigures e = compare_distances({{1, 1.0625, 10, 100}}, {{1, 1, 1, 1}});
  const ErrorHistogram& h = e.histogram;
  ASSERT_EQ(h.decades.size(), h.counts.size() + 1);
  EXPECT_EQ(h.decades.front(), -17);
  EXPECT_EQ(h.decades.back(), 1);
  EXPECT_EQ(h.zero, 1u);
  EXPECT_EQ(std::accumulate(h.counts.begin(), h.counts.end(), std::uint64_t{0}), 3u);
  EXPECT_EQ(h.counts.back(), 2u) << "from 10^0.5 on";
  const auto bin = static_cast<std::size_t>(2 * (-1.5 + 17));
  EXPECT_EQ(h.decades[bin], -1.5);
  EXPECT_EQ(h.counts[bin], 1u);
}

TEST(CompareDistances, HistogramHasRoomForTheSmallestError) {
  const double next = std::nextafter(1.0, 0.0);  // 1 - 2^-53
  const ErrorFigures e = compare_distances({{next}}, {{1}});
  EXPECT_EQ(e.histogram.zero, 0u);
  EXPECT_EQ(e.histogram.counts[2], 1u) << "1.1e-16 lies in [10^-16, 10^-15.5)";
}

}  // namespace
}  // namespace geodrome
