// SPDX-License-Identifier: MIT
#include "geodrome/detail/point_triangle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace geodrome {
namespace {

using detail::closest_on_triangle, detail::TrianglePoint;

using Corners = std::array<Vec3, 3>;

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
Vec3 random_point(std::mt19937_64& random) { return {uniform(random), uniform(random), uniform(random)}; }

Vec3 place(const Corners& c, const std::array<double, 3>& b) { return b[0] * c[0] + b[1] * c[1] + b[2] * c[2]; }

/// The optimality condition of a closest point x of a convex set: (query - x).(corner - x) <= 0 for every corner.
double worst_improvement(const Vec3& query, const Corners& corners, const Vec3& x) {
  double worst = 0;
  for (const Vec3& corner : corners) worst = std::max(worst, dot(query - x, corner - x));
  return worst;
}

TEST(ClosestOnTriangle, FindsThePointThatNoCornerDirectionImproves) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const Corners corners = {random_point(random), random_point(random), random_point(random)};
    const Vec3 query = 3 * random_point(random) - Vec3{1, 1, 1};
    const TrianglePoint found = closest_on_triangle(query, corners);
    EXPECT_LE(worst_improvement(query, corners, place(corners, found.b)), 1e-13) << i;
  }
}

TEST(ClosestOnTriangle, StatesTheDistanceOfThePointItNames) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const Corners corners = {random_point(random), random_point(random), random_point(random)};
    const Vec3 query = random_point(random);
    const TrianglePoint found = closest_on_triangle(query, corners);
    EXPECT_NEAR(std::sqrt(found.squared_distance), distance(query, place(corners, found.b)), 1e-15) << i;
  }
}

TEST(ClosestOnTriangle, GivesBarycentricCoordinates) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Corners corners = {random_point(random), random_point(random), random_point(random)};
    const auto b = closest_on_triangle(3 * random_point(random), corners).b;
    EXPECT_TRUE(b[0] >= 0 && b[1] >= 0 && b[2] >= 0) << i;
    EXPECT_NEAR(b[0] + b[1] + b[2], 1, 4e-16) << i;
  }
}

TEST(ClosestOnTriangle, IsExactAtCorners) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 3000; ++i) {
    const Corners corners = {random_point(random), random_point(random), random_point(random)};
    std::array<double, 3> expected{};
    expected[i % 3] = 1;
    const TrianglePoint found = closest_on_triangle(corners[i % 3], corners);
    EXPECT_EQ(found.b, expected) << i;
    EXPECT_EQ(found.squared_distance, 0) << i;
  }
}

TEST(ClosestOnTriangle, TreatsASliverAsItsLongestEdge) {
  const Corners corners = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{2, 0, 0}};
  EXPECT_DOUBLE_EQ(closest_on_triangle({1.5, 2, 0}, corners).squared_distance, 4);
}

TEST(ClosestOnTriangle, TreatsCoincidingCornersAsAPoint) {
  const Corners corners = {Vec3{1, 1, 1}, Vec3{1, 1, 1}, Vec3{1, 1, 1}};
  const TrianglePoint found = closest_on_triangle({1, 1, 3}, corners);
  EXPECT_DOUBLE_EQ(found.squared_distance, 4);
  EXPECT_EQ(found.b[0] + found.b[1] + found.b[2], 1);
}

TEST(ClosestOnTriangle, StaysOptimalOnNeedles) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = random_point(random), q = random_point(random);
    const double width = std::pow(10, -14 * uniform(random));
    const Corners corners = {p, q, p + uniform(random) * (q - p) + width * random_point(random)};
    const Vec3 query = random_point(random);
    EXPECT_LE(worst_improvement(query, corners, place(corners, closest_on_triangle(query, corners).b)), 1e-12) << i;
  }
}

TEST(ClosestOnTriangle, GivesBothFacesOfAnEdgeTheSameDistance) {
  std::mt19937_64 random(6);
  int on_edge = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random_point(random), q = random_point(random), query = 4 * random_point(random);
    const TrianglePoint one = closest_on_triangle(query, {p, q, random_point(random)});
    const TrianglePoint other = closest_on_triangle(query, {q, p, random_point(random)});
    if (one.b[2] != 0 || other.b[2] != 0) continue;
    ++on_edge;
    EXPECT_EQ(one.squared_distance, other.squared_distance) << i;
  }
  EXPECT_GT(on_edge, 100);
}

}  // namespace
}  // namespace geodrome
