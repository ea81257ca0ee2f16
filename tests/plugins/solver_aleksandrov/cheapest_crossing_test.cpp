// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/cheapest_crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/meshes.hpp"

namespace geodrome::aleksandrov {
namespace {

double cost(Point2 p, double above, Point2 q, double below, double along, double leave, double enter) {
  return above * std::hypot(p.x - leave, p.y) + along * std::abs(leave - enter) + below * std::hypot(q.x - enter, q.y);
}

/// The least over both places on the edge, which is convex in them: one after the other, by thirds.
double brute_force(Point2 p, double above, Point2 q, double below, double along) {
  const double low = std::min(p.x, q.x), high = std::max(p.x, q.x);
  const auto least = [](double a, double b, const auto& value) {
    for (int step = 0; step < 100; ++step) {
      const double c = a + (b - a) / 3, d = b - (b - a) / 3;
      (value(c) < value(d) ? b : a) = value(c) < value(d) ? d : c;
    }
    return value(a);
  };
  return least(low, high, [&](double leave) {
    return least(low, high, [&](double enter) { return cost(p, above, q, below, along, leave, enter); });
  });
}

struct Scene {
  Point2 p, q;
  double above, below, along;
};

Scene random_scene(std::mt19937_64& random) {
  const auto uniform = [&] { return test::uniform(random); };
  Scene s{{4 * uniform(), uniform()}, {4 * uniform(), -uniform()}, std::exp(2 * uniform()), std::exp(2 * uniform()), 0};
  s.along = std::min(s.above, s.below) * (random() % 2 ? 1 : 0.3 + 0.7 * uniform());
  if (random() % 8 == 0) s.p.y = 0;
  if (random() % 8 == 0) s.q.y = 0;
  if (random() % 8 == 0) s.q.x = s.p.x;
  return s;
}

TEST(CheapestCrossing, IsTheLeastOfAllWaysOverTheEdge) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const Scene s = random_scene(random);
    const Crossing way = cheapest_crossing(s.p, s.above, s.q, s.below, s.along);
    EXPECT_NEAR(way.cost, cost(s.p, s.above, s.q, s.below, s.along, way.leave, way.enter), 1e-14 * (1 + way.cost));
    EXPECT_NEAR(way.cost, brute_force(s.p, s.above, s.q, s.below, s.along), 1e-9 * (1 + way.cost)) << i;
  }
}

/// A dear face that is hardly entered: the way leaves it almost at once, far less than rounding of the whole length
/// away.
TEST(CheapestCrossing, IsCheapestNextToAnEdgeOfADearFace) {
  for (const double height : {1e-9, 1e-12, 1e-15, 1e-18}) {
    const Crossing way = cheapest_crossing({0, height}, 1e8, {1, -1}, 1, 1);
    EXPECT_LE(way.cost, (std::sqrt(2) + 1e8 * height) * (1 + 1e-15)) << height;
  }
}

TEST(CheapestCrossing, IsAlikeForWeightsOfAnySize) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 100; ++i) {
    const Scene s = random_scene(random);
    const Crossing plain = cheapest_crossing(s.p, s.above, s.q, s.below, s.along);
    for (const int exponent : {-600, 600}) {
      const double times = std::ldexp(1, exponent);
      const Crossing way = cheapest_crossing(s.p, times * s.above, s.q, times * s.below, times * s.along);
      EXPECT_EQ(way.cost, times * plain.cost);
      EXPECT_EQ(way.leave, plain.leave);
      EXPECT_EQ(way.enter, plain.enter);
    }
  }
}

TEST(CheapestCrossing, IsStraightWhereAllCostsTheSame) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i) {
    const Scene s = random_scene(random);
    EXPECT_NEAR(cheapest_crossing(s.p, 2, s.q, 2, 2).cost, 2 * length(s.p - s.q), 1e-13);
  }
}

TEST(CheapestCrossing, FollowsSnellsLaw) {
  const Crossing way = cheapest_crossing({0, 1}, 1.5, {2, -1}, 1, 1);
  ASSERT_EQ(way.leave, way.enter);
  EXPECT_NEAR(1.5 * way.leave / std::hypot(way.leave, 1), (2 - way.leave) / std::hypot(2 - way.leave, 1), 1e-12);
}

}  // namespace
}  // namespace geodrome::aleksandrov
