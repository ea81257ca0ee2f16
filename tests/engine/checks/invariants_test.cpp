// SPDX-License-Identifier: MIT
#include "engine/checks/invariants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace geodrome {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Sources and targets on a cylinder of radius 1 with its true geodesic distances: a metric above the straight line.
struct Cylinder {
  explicit Cylinder(std::size_t count, std::uint64_t first_target = 0) {
    std::mt19937_64 random(7);
    std::vector<double> angle, height;
    for (std::size_t i = 0; i < count + first_target; ++i) {
      angle.push_back(6.28 * uniform(random));
      height.push_back(3 * uniform(random));
    }
    const auto point = [&](std::size_t i) { return Vec3{std::cos(angle[i]), std::sin(angle[i]), height[i]}; };
    for (std::size_t i = 0; i < count; ++i) {
      row_ids.push_back(i), column_ids.push_back(first_target + i);
      row_points.push_back(point(i)), column_points.push_back(point(first_target + i));
    }
    const double turn = 2 * std::acos(-1.0);
    for (const std::uint64_t s : row_ids)
      for (const std::uint64_t t : column_ids) {
        const double around = std::abs(angle[s] - angle[t]);
        entries.push_back(std::hypot(std::min(around, turn - around), height[s] - height[t]));
      }
  }

  double& at(std::size_t row, std::size_t column) { return entries[row * column_ids.size() + column]; }

  MatrixView view() const {
    const auto read = [this](std::uint64_t row) {
      const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(row * column_ids.size());
      return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(column_ids.size()));
    };
    return {row_ids, column_ids, row_points, column_points, starts, read};
  }

  Invariants check(const InvariantOptions& options = {}) const { return check_invariants(view(), options); }

  std::vector<std::uint64_t> row_ids, column_ids;
  std::vector<Vec3> row_points, column_points;
  std::vector<double> entries, starts;
};

TEST(Invariants, HoldForTrueDistances) { EXPECT_TRUE(Cylinder(40).check().holds()); }

TEST(Invariants, TestEveryEntryAndPairOfASmallMatrix) {
  const Invariants result = Cylinder(40).check();
  EXPECT_EQ(result.entries, 1600u);
  EXPECT_EQ(result.identity.tested, 40u);
  EXPECT_EQ(result.symmetry.tested, 40u * 39);
  EXPECT_EQ(result.triangle.tested, 200'000u);
}

TEST(Invariants, FindASourceThatIsNotAtDistanceZero) {
  Cylinder cylinder(40);
  cylinder.at(7, 7) = 0.01;
  const Invariants result = cylinder.check();
  EXPECT_FALSE(result.identity.holds());
  EXPECT_EQ(result.identity.violated, 1u);
  EXPECT_EQ(result.identity.row, 7u);
  EXPECT_NEAR(result.identity.worst * result.scale, 0.01, 1e-12);
}

TEST(Invariants, FindADistanceBelowTheStraightLine) {
  Cylinder cylinder(40);
  const double straight = distance(cylinder.row_points[3], cylinder.column_points[9]);
  cylinder.at(3, 9) = straight * 0.999;
  const Invariants result = cylinder.check();
  EXPECT_FALSE(result.euclid.holds());
  EXPECT_EQ(result.euclid.row, 3u);
  EXPECT_EQ(result.euclid.column, 9u);
  EXPECT_NEAR(result.euclid.worst * result.scale, straight * 0.001, 1e-12);
}

TEST(Invariants, AllowDistancesAsLowAsTheSmallestWeightTimesTheStraightLine) {
  Cylinder cylinder(40);
  for (double& entry : cylinder.entries) entry *= 0.25;
  InvariantOptions options;
  EXPECT_FALSE(cylinder.check(options).euclid.holds());
  options.smallest_weight = 0.25;
  EXPECT_TRUE(cylinder.check(options).holds());
}

TEST(Invariants, FindADistanceBelowTheSmallestWeightTimesTheStraightLine) {
  Cylinder cylinder(40);
  for (double& entry : cylinder.entries) entry *= 4;
  cylinder.at(3, 9) = 3.9 * distance(cylinder.row_points[3], cylinder.column_points[9]);
  InvariantOptions options;
  EXPECT_TRUE(cylinder.check(options).euclid.holds());
  options.smallest_weight = 4;
  EXPECT_EQ(cylinder.check(options).euclid.violated, 1u);
}

TEST(Invariants, FindAnAsymmetricPair) {
  Cylinder cylinder(40);
  cylinder.at(5, 11) *= 1 + 1e-6;
  const Invariants result = cylinder.check();
  EXPECT_FALSE(result.symmetry.holds());
  EXPECT_EQ(result.symmetry.violated, 1u);
  EXPECT_EQ(result.symmetry.row, 5u);
  EXPECT_EQ(result.symmetry.column, 11u);
}

TEST(Invariants, FindASymmetricViolationOfTheTriangleInequality) {
  Cylinder cylinder(40);
  cylinder.at(5, 11) *= 3;
  cylinder.at(11, 5) *= 3;
  const Invariants result = cylinder.check();
  EXPECT_TRUE(result.symmetry.holds());
  EXPECT_FALSE(result.triangle.holds());
  EXPECT_EQ(std::min(result.triangle.row, result.triangle.column), 5u);
  EXPECT_EQ(std::max(result.triangle.row, result.triangle.column), 11u);
}

TEST(Invariants, FindAnUnreachablePairThatHasAWay) {
  Cylinder cylinder(40);
  cylinder.at(5, 11) = cylinder.at(11, 5) = inf;
  const Invariants result = cylinder.check();
  EXPECT_EQ(result.infinite, 2u);
  EXPECT_EQ(result.triangle.worst, inf);
}

TEST(Invariants, FindOneSidedUnreachability) {
  Cylinder cylinder(40);
  cylinder.at(5, 11) = inf;
  EXPECT_EQ(cylinder.check().symmetry.violated, 1u);
}

TEST(Invariants, FindAnEntryThatWasNotComputed) {
  Cylinder cylinder(40);
  cylinder.at(2, 6) = nan;
  const Invariants result = cylinder.check();
  EXPECT_FALSE(result.computed.holds());
  EXPECT_EQ(result.not_computed, 1u);
  EXPECT_EQ(result.computed.row, 2u);
  EXPECT_EQ(result.computed.column, 6u);
}

TEST(Invariants, AllowNotComputedForDroppedPoints) {
  Cylinder cylinder(40);
  cylinder.column_points[6] = {nan, nan, nan};
  for (std::size_t row = 0; row < 40; ++row) cylinder.at(row, 6) = nan;
  const Invariants result = cylinder.check();
  EXPECT_TRUE(result.holds());
  EXPECT_EQ(result.not_computed, 40u);
}

TEST(Invariants, HoldForTwoComponents) {
  Cylinder cylinder(40);
  for (std::size_t row = 0; row < 40; ++row)
    for (std::size_t column = 0; column < 40; ++column)
      if ((row < 15) != (column < 15)) cylinder.at(row, column) = inf;
  EXPECT_TRUE(cylinder.check().holds());
}

TEST(Invariants, HoldBeyondACutOff) {
  Cylinder cylinder(40);
  for (double& entry : cylinder.entries)
    if (entry > 1) entry = inf;
  InvariantOptions options;
  options.radius = 1;
  EXPECT_TRUE(cylinder.check(options).holds());
}

TEST(Invariants, FindAnEntryCutOffTooEarly) {
  Cylinder cylinder(40);
  for (double& entry : cylinder.entries)
    if (entry > 1) entry = inf;
  InvariantOptions options;
  options.radius = 2;
  EXPECT_FALSE(cylinder.check(options).holds());
}

TEST(Invariants, TakeStartDistancesOff) {
  Cylinder cylinder(40);
  for (std::size_t row = 0; row < 40; ++row) {
    cylinder.starts.push_back(0.1 * static_cast<double>(row));
    for (std::size_t column = 0; column < 40; ++column) cylinder.at(row, column) += cylinder.starts[row];
  }
  EXPECT_TRUE(cylinder.check().holds());
}

/// A start distance leaves less of the cut-off for the way; one beyond it leaves nothing.
TEST(Invariants, HoldBeyondACutOffThatStartDistancesCount) {
  Cylinder cylinder(40);
  for (std::size_t row = 0; row < 40; ++row) {
    cylinder.starts.push_back(0.06 * static_cast<double>(row));
    for (std::size_t column = 0; column < 40; ++column) {
      double& entry = cylinder.at(row, column);
      entry += cylinder.starts[row];
      if (entry > 2) entry = inf;
    }
  }
  EXPECT_EQ(cylinder.at(39, 39), inf);
  const Invariants result = cylinder.check({.radius = 2});
  EXPECT_TRUE(result.holds()) << result.symmetry.violated << ", " << result.triangle.violated;
  EXPECT_FALSE(cylinder.check({.radius = 2.5}).holds()) << "cut off too early";
}

TEST(Invariants, MatchPointsByInputRowWhereListsOverlapPartly) {
  const Cylinder cylinder(40, 30);  // sources 0 ... 39, targets 30 ... 69
  const Invariants result = cylinder.check();
  EXPECT_TRUE(result.holds());
  EXPECT_EQ(result.identity.tested, 10u);
  EXPECT_EQ(result.symmetry.tested, 10u * 9);
}

TEST(Invariants, AllowTheSolversFactor) {
  Cylinder cylinder(40);
  std::mt19937_64 random(11);
  for (double& entry : cylinder.entries) entry *= 1 + 0.05 * uniform(random);
  InvariantOptions options;
  EXPECT_FALSE(cylinder.check(options).holds());
  options.factor = 1.05;
  EXPECT_TRUE(cylinder.check(options).holds());
}

TEST(Invariants, MeasureWhatNothingPromisesWithoutFailing) {
  Cylinder cylinder(40);
  cylinder.at(5, 11) *= 1.5;
  InvariantOptions options;
  options.factor = inf;
  const Invariants result = cylinder.check(options);
  EXPECT_TRUE(result.holds());
  EXPECT_EQ(result.symmetry.violated, 1u);
}

TEST(Invariants, AllowTheRoundingOfSinglePrecision) {
  Cylinder cylinder(40);
  for (double& entry : cylinder.entries) entry = static_cast<float>(entry);
  InvariantOptions options;
  EXPECT_FALSE(cylinder.check(options).euclid.holds() && cylinder.check(options).triangle.holds());
  options.float32 = true;
  EXPECT_TRUE(cylinder.check(options).holds());
}

TEST(Invariants, ReadOnlyAsManyRowsAsAllowed) {
  const Cylinder cylinder(40);
  MatrixView view = cylinder.view();
  std::vector<std::uint64_t> rows;
  view.read = [&, read = view.read](std::uint64_t row) { return rows.push_back(row), read(row); };
  InvariantOptions options;
  options.entries = 400;
  EXPECT_EQ(check_invariants(view, options).rows, 10u);
  EXPECT_EQ(rows.size(), 10u);
}

TEST(Invariants, DependOnTheSeedAlone) {
  Cylinder cylinder(40);
  for (std::size_t i = 0; i < 40; ++i) cylinder.at(i, i) = 0.001 * static_cast<double>(i + 1);
  InvariantOptions options;
  options.entries = 120;
  options.seed = 5;
  const Invariants one = cylinder.check(options), same = cylinder.check(options);
  EXPECT_EQ(one.identity.row, same.identity.row);
  EXPECT_EQ(one.triangle.worst, same.triangle.worst);
}

TEST(Invariants, HoldForAnEmptyMatrix) { EXPECT_TRUE(Cylinder(0).check().holds()); }

}  // namespace
}  // namespace geodrome
