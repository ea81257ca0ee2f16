// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "plugins/tangent_jet/smooth/quartic_fit.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

constexpr FitRule through_base{8, true}, with_constant{3, false};

double quartic_height(double x, double y) {
  return 0.3 * x * x - 0.2 * x * y + 0.5 * x * x * x - 0.4 * x * y * y + 0.7 * x * x * y * y - 0.6 * y * y * y * y;
}

/// Points over the unit square around the origin.
std::vector<Vec3> points_of(double (*height)(double, double), std::size_t count, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    points.push_back({x, y, height(x, y)});
  }
  return points;
}

std::vector<Neighbour> all_around(const std::vector<Vec3>& points, const Vec3& base) {
  std::vector<Neighbour> around;
  Neighbours(points).nearest(base, points.size(), around);
  return around;
}

QuarticFit fit(const std::vector<Vec3>& points, const FitRule& rule, const Vec3& normal = {0, 0, 1}) {
  return fit_quartic(points, all_around(points, {}), {}, normal, rule);
}

TEST(QuarticFit, FindsTheQuarticThatPointsLieOn) {
  for (const FitRule& rule : {through_base, with_constant}) {
    const QuarticFit found = fit(points_of(quartic_height, 40, 1), rule);
    ASSERT_TRUE(found.determined);
    EXPECT_LT(found.residual, 1e-12);
    test::Random random(2);
    for (int i = 0; i < 20; ++i) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      EXPECT_NEAR(found.quartic.above({x, y, quartic_height(x, y)}), 0, 1e-11);
    }
  }
}

TEST(QuarticFit, DerivativesAreThoseOfTheHeight) {
  const Quartic q = fit(points_of(quartic_height, 40, 3), with_constant).quartic;
  constexpr double h = 1e-4;
  test::Random random(4);
  for (int i = 0; i < 20; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const Height at = q.at(x, y), east = q.at(x + h, y), west = q.at(x - h, y), north = q.at(x, y + h),
                 south = q.at(x, y - h);
    EXPECT_NEAR(at.x, (east.z - west.z) / (2 * h), 1e-6);
    EXPECT_NEAR(at.y, (north.z - south.z) / (2 * h), 1e-6);
    EXPECT_NEAR(at.xx, (east.x - west.x) / (2 * h), 1e-6);
    EXPECT_NEAR(at.xy, (north.x - south.x) / (2 * h), 1e-6);
    EXPECT_NEAR(at.yy, (north.y - south.y) / (2 * h), 1e-6);
  }
}

TEST(QuarticFit, PassesThroughTheBaseWhereItHasNoConstant) {
  const std::vector<Vec3> points = points_of([](double x, double y) { return 0.2 + 0.1 * std::sin(9 * x * y); }, 40, 5);
  EXPECT_EQ(fit(points, through_base).quartic.at(0, 0).z, 0);
  EXPECT_NEAR(fit(points, with_constant).quartic.at(0, 0).z, 0.2, 0.05);
}

TEST(QuarticFit, ResidualIsTheDeviationOfNoise) {
  for (const FitRule& rule : {through_base, with_constant}) {
    double squares = 0;
    constexpr int trials = 300;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<Vec3> points = points_of(quartic_height, 32, 100 + trial);
      test::Random random(trial);
      for (Vec3& p : points) p.z += random.uniform(-1, 1) * std::sqrt(3) * 1e-3;
      squares += std::pow(fit(points, rule).residual, 2);
    }
    EXPECT_NEAR(std::sqrt(squares / trials), 1e-3, 1e-4);
  }
}

TEST(QuarticFit, HeightsDeviateByTheResidualTimesTheLeverage) {
  // With equal weights the leverage is exact, not a bound.
  const std::vector<Vec3> exact = points_of(quartic_height, 60, 7);
  constexpr int trials = 1000;
  for (const double x : {0.0, 0.7}) {
    double squares = 0, leverage = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<Vec3> points = exact;
      test::Random random(trial);
      for (Vec3& p : points) p.z += random.uniform(-1, 1) * std::sqrt(3) * 1e-6;
      const QuarticFit found = fit(points, {0, false});
      const Vec3 place{x, -x, quartic_height(x, -x)};
      squares += std::pow(found.quartic.above(place), 2);
      leverage = found.leverage(dot(place, found.quartic.u), dot(place, found.quartic.v));
    }
    EXPECT_NEAR(std::sqrt(squares / trials) / 1e-6, leverage, 0.1 * leverage);
  }
}

TEST(QuarticFit, IsNotDeterminedByTooFewPointsOrTooFewRows) {
  EXPECT_FALSE(fit(points_of(quartic_height, 23, 8), with_constant).determined);
  EXPECT_TRUE(fit(points_of(quartic_height, 24, 8), with_constant).determined);
  std::vector<Vec3> rows;
  for (int j = -2; j < 2; ++j)
    for (int i = 0; i < 20; ++i) rows.push_back({0.1 * i - 1, 0.5 * j, quartic_height(0.1 * i - 1, 0.5 * j)});
  EXPECT_FALSE(fit(rows, with_constant).determined);
  for (int i = 0; i < 20; ++i) rows.push_back({0.1 * i - 1, 1, quartic_height(0.1 * i - 1, 1)});
  EXPECT_TRUE(fit(rows, with_constant).determined);
}

}  // namespace
}  // namespace geodrome
