// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geodrome/errors.hpp"
#include "tests/support/shape_equations.hpp"
#include "tools/bench/samples/sample_case.hpp"
#include "tools/bench/shapes/broken_geodesic.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr double pi = std::numbers::pi;

/// Rounding, over lengths of a few units and some hundred steps.
constexpr double rounding = 1e-13;

class SmoothShape : public testing::TestWithParam<std::string> {
 protected:
  const std::string& shape() const { return GetParam(); }
  const LevelSet level_ = level_set_of(GetParam());
};

TEST_P(SmoothShape, HasItsSamplesOnTheLevelSetToRounding) {
  for (const char* sampling : {"uniform", "blue", "grid"})
    for (const Vec3& p : make_sample({shape(), sampling, 2000, 3}).points) {
      const LevelValue f = level_(p);
      ASSERT_LE(std::abs(f.value) / norm(f.gradient), 1e-15) << sampling;
    }
}

/// Against the definition written down a second time.
TEST_P(SmoothShape, HasTheOutwardNormalOfTheShape) {
  for (const Vec3& p : shapes::sample(shape(), {.points = 200}).points) {
    const Vec3 expected = test::shape_gradient(shape(), p);
    ASSERT_LE(norm(normal_at(level_, p) - expected / norm(expected)), 1e-7);
  }
}

TEST_P(SmoothShape, HasTheHessianOfItsGradient) {
  constexpr double h = 1e-5;
  for (const Vec3& p : shapes::sample(shape(), {.points = 200}).points) {
    const LevelValue f = level_(p);
    for (const Vec3& d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      const Vec3 expected = (level_(p + h * d).gradient - level_(p - h * d).gradient) / (2 * h);
      ASSERT_LE(norm(f.hessian * d - expected), 1e-6 * (1 + norm(expected)));
    }
  }
}

TEST_P(SmoothShape, ShotGeodesicsStayOnItWithUnitSpeedAndComeBack) {
  for (const Vec3& p : shapes::sample(shape(), {.points = 20}).points) {
    const Vec3 side = cross(normal_at(level_, p), {0.6, 0.48, 0.64});
    const GeodesicArc there = shoot(level_, p, side / norm(side), 0.3);
    const GeodesicArc back = shoot(level_, there.end, -there.arriving, 0.3);
    EXPECT_LE(std::abs(dot(there.arriving, normal_at(level_, there.end))), rounding);
    EXPECT_LE(distance(there.end, on_level_set(level_, there.end)), rounding);
    EXPECT_LE(distance(back.end, p), 10 * rounding);  // the geodesics of the trefoil spread by a factor of 5
  }
}

/// The Jacobi field is the derivative of the end by the direction at the start.
TEST_P(SmoothShape, JacobiFieldsAreTheDerivativesOfTheEnd) {
  constexpr double h = 1e-5;
  for (const Vec3& p : shapes::sample(shape(), {.points = 20}).points) {
    const Vec3 normal = normal_at(level_, p), side = cross(normal, {0.6, 0.48, 0.64}), ahead = side / norm(side);
    const Vec3 left = cross(normal, ahead);
    const auto end = [&](double turn) {
      return shoot(level_, p, std::cos(turn) * ahead + std::sin(turn) * left, 0.2).end;
    };
    const GeodesicArc arc = shoot(level_, p, ahead, 0.2);
    const Vec3 across = cross(normal_at(level_, arc.end), arc.arriving);
    EXPECT_NEAR(dot(end(h) - end(-h), across) / (2 * h), arc.turned.value, 1e-6);
    EXPECT_NEAR(arc.moved.value * arc.turned.slope - arc.moved.slope * arc.turned.value, 1, rounding);  // Wronskian
  }
}

TEST_P(SmoothShape, ConnectingFindsWhatWasShot) {
  for (const Vec3& p : shapes::sample(shape(), {.points = 20}).points) {
    const double length = 0.5 / curvature_bound(level_, p);
    const Vec3 side = cross(normal_at(level_, p), {0.6, 0.48, 0.64});
    const GeodesicArc shot = shoot(level_, p, side / norm(side), length);
    const GeodesicArc found = connect(level_, p, shot.end);
    EXPECT_NEAR(found.length, length, rounding);
    EXPECT_LE(norm(found.leaving - shot.leaving), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SmoothShape, testing::ValuesIn(smooth_shapes()));

TEST(LevelSets, RefuseAShapeThatIsNotSmoothOrClosed) {
  EXPECT_THROW(level_set_of("cut-sphere"), OptionError);
  EXPECT_THROW(level_set_of("icosphere"), OptionError);
}

TEST(Resampled, HasEqualStepsAndKeepsItsEnds) {
  const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 2, 0}};
  const std::vector<Vec3> made = resampled(line, 6);
  ASSERT_EQ(made.size(), 7u);
  EXPECT_EQ(made.front(), line.front());
  EXPECT_EQ(made.back(), line.back());
  for (std::size_t i = 0; i + 1 < made.size(); ++i) EXPECT_NEAR(distance(made[i], made[i + 1]), 0.5, 1e-15) << i;
}

/// Points along an ellipse of the ellipsoid in one of its planes of symmetry, from an angle to another, moved beside
/// it.
std::vector<Vec3> beside_ellipse(double a, double b, double from, double to, bool upright) {
  std::vector<Vec3> points;
  constexpr int pieces = 40;
  for (int i = 0; i <= pieces; ++i) {
    const double t = from + (to - from) * i / pieces, beside = 0.05 * std::sin(pi * i / pieces);
    const double x = a * std::cos(t), y = b * std::sin(t);
    points.push_back(upright ? Vec3{x, beside, y} : Vec3{x, y, beside});
  }
  return points;
}

/// By the trapezoidal rule over a period of the integrand's symmetric continuation, which converges exponentially.
double quarter_of_ellipse(double a, double b) {
  constexpr int pieces = 200;
  double sum = 0.5 * (a + b);
  for (int i = 1; i < pieces; ++i) {
    const double t = 0.5 * pi * i / pieces;
    sum += std::hypot(a * std::sin(t), b * std::cos(t));
  }
  return 0.5 * pi * sum / pieces;
}

TEST(Shortened, FindsQuartersOfTheEllipsoidsPrincipalEllipses) {
  const LevelSet level = level_set_of("ellipsoid");
  EXPECT_NEAR(shortened(level, beside_ellipse(1, 0.6, 0, pi / 2, true)).length, quarter_of_ellipse(1, 0.6), rounding);
  EXPECT_NEAR(shortened(level, beside_ellipse(1, 0.8, 0, pi / 2, false)).length, quarter_of_ellipse(1, 0.8), rounding);
}

/// Across half the trefoil, whose geodesics spread by a factor of 1e8: the length does not depend on where the pieces
/// end.
TEST(Shortened, MoreAndShorterPiecesChangeNothing) {
  const LevelSet level = level_set_of("trefoil");
  std::vector<Vec3> line;
  for (int i = 0; i <= 200; ++i) {
    const Vec3 centre = test::trefoil_curve(pi * i / 200);
    line.push_back(on_level_set(level, centre + Vec3{0, 0, 0.1}));
  }
  const GeodesicPath usual = shortened(level, line), finer = shortened(level, line, 0.4);
  EXPECT_GE(finer.nodes.size(), 2 * usual.nodes.size() - 2);
  EXPECT_NEAR(usual.length, finer.length, rounding);
  EXPECT_LE(usual.slack, rounding);
  EXPECT_EQ(usual.nodes.front(), line.front());
  EXPECT_EQ(usual.nodes.back(), line.back());
}

/// Half a great circle and more is a geodesic, but not the shortest of its neighbours.
TEST(Shortened, LeavesAGeodesicBeyondItsConjugatePoint) {
  const LevelSet level = level_set_of("sphere");
  std::vector<Vec3> line;
  for (int i = 0; i <= 40; ++i) {
    const double t = 1.1 * pi * i / 40, lift = 0.1 * std::sin(pi * i / 40);
    line.push_back({std::cos(t) * std::cos(lift), std::sin(t) * std::cos(lift), std::sin(lift)});
  }
  EXPECT_NEAR(shortened(level, line).length, 0.9 * pi, rounding);
}

}  // namespace
}  // namespace geodrome::bench
