// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "plugins/solver_schreiber/generator.hpp"
#include "tests/plugins/solver_schreiber/wavefronts.hpp"

namespace geodrome::schreiber::test {
namespace {

constexpr int cases = 20000;

Generator random_generator(Random& random) {
  Generator g{random.uniform(-2, 3), -power(random, 1e-3, 2), random.uniform(0, 9), 0, 0, 0, 0, 7, 11};
  const double a = random.uniform(0, std::numbers::pi), b = random.uniform(0, std::numbers::pi);
  g.low_x = std::cos(std::max(a, b)), g.low_y = std::sin(std::max(a, b));
  g.high_x = std::cos(std::min(a, b)), g.high_y = std::sin(std::min(a, b));
  return g;
}
long double angle_to(const Generator& g, double px, double py) {
  return std::atan2(static_cast<long double>(py) - g.y, static_cast<long double>(px) - g.x);
}
/// From the direction of a ray to that of a point, counter-clockwise: the point is on its left if positive.
long double turn(const Generator& g, double dx, double dy, double px, double py) {
  const long double off = angle_to(g, px, py) - std::atan2(static_cast<long double>(dy), static_cast<long double>(dx));
  return std::remainder(off, 2 * std::numbers::pi_v<long double>);
}

TEST(SchreiberGenerator, ItsRaysMeetTheHalfEdgeWhereTheyWereAimed) {
  Random random(1);
  for (int i = 0; i < cases; ++i) {
    Generator g = random_generator(random);
    const double length = power(random, 0.1, 2), a = random.uniform(-1, 3), b = random.uniform(-1, 3);
    g.set_low(a, 0), g.set_high(b, 0);
    EXPECT_NEAR(std::hypot(g.low_x, g.low_y), 1, 2 * epsilon);
    EXPECT_NEAR(std::hypot(g.high_x, g.high_y), 1, 2 * epsilon);
    const auto rounding = [&](double place) { return 8 * epsilon * (1 + (g.x - place) * (g.x - place) / -g.y); };
    ASSERT_NEAR(g.low(length), std::clamp(a, 0.0, length), rounding(a)) << i;
    ASSERT_NEAR(g.high(length), std::clamp(b, 0.0, length), rounding(b)) << i;
  }
}

TEST(SchreiberGenerator, ARayThatNeverClimbsToTheHalfEdgeMeetsItsNearerEnd) {
  const Generator g{1, -2, 0, -1, 0, 0.6, -0.8, 0, 0};
  EXPECT_EQ(g.low(3), 0);
  EXPECT_EQ(g.high(3), 3);
  for (const auto& [x, low] : {std::pair(-4.0, 0.0), std::pair(1.0, 1.0), std::pair(5.0, 3.0)}) {
    const Generator down{x, -2, 0, 0, -1, 0, 0, 0, 0};
    EXPECT_EQ(down.low(3), low) << "straight down from " << x;
    EXPECT_EQ(down.high(3), low) << "of no direction from " << x;
  }
  const Generator on_it{1, 1e-17, 0, -0.6, 0.8, 0.6, 0.8, 0, 0};  // above by rounding
  EXPECT_EQ(on_it.low(3), 1);
  EXPECT_EQ(on_it.high(3), 1);
}

TEST(SchreiberGenerator, CoversWhatLiesBetweenItsRays) {
  Random random(2);
  int covered = 0;
  for (int i = 0; i < cases; ++i) {
    const Generator g = random_generator(random);
    const double px = random.uniform(-3, 4), py = random.uniform(-3, 3);
    const long double from_low = turn(g, g.low_x, g.low_y, px, py), from_high = turn(g, g.high_x, g.high_y, px, py);
    if (std::abs(from_low) < 1e-13L || std::abs(from_high) < 1e-13L) continue;
    ASSERT_EQ(g.inside_low(px, py), from_low < 0) << i;
    ASSERT_EQ(g.inside_high(px, py), from_high > 0) << i;
    ASSERT_EQ(g.has_left(px, py), from_low < 0) << i;
    ASSERT_EQ(g.has_right(px, py), from_high > 0) << i;
    ASSERT_EQ(g.covers(px, py), from_low < 0 && from_high > 0) << i;
    covered += g.covers(px, py);
  }
  EXPECT_GT(covered, 1000);
}

TEST(SchreiberGenerator, APointOnARayIsInsideAndHasNothingBeyondIt) {
  const Generator g{1, -1, 0, 0, 1, 1, 0, 0, 0};
  EXPECT_TRUE(g.inside_low(1, 3) && g.inside_high(1, 3) && g.covers(1, 3));
  EXPECT_FALSE(g.has_left(1, 3));
  EXPECT_TRUE(g.has_right(1, 3));
  EXPECT_TRUE(g.covers(4, -1) && g.has_left(4, -1));
  EXPECT_FALSE(g.has_right(4, -1));
}

/// How much longer, as a share, the way to a point is that bends where a ray meets the half-edge.
long double bend(const Generator& g, double dx, double dy, double px, double py) {
  const long double along = -static_cast<long double>(g.y) / dy, place = g.x + along * dx;
  const long double way = std::hypot(px - place, static_cast<long double>(py));
  const long double line = std::hypot(static_cast<long double>(px) - g.x, static_cast<long double>(py) - g.y);
  return (along + way) / line - 1;
}

TEST(SchreiberGenerator, ReachesPointsBeyondARayByRoundingOnly) {
  Random random(3);
  int reached = 0, missed = 0;
  for (int i = 0; i < cases; ++i) {
    Generator g = random_generator(random);
    g.y = -power(random, 0.3, 2), g.sigma = 0;
    g.set_low(random.uniform(-1, 1), 0), g.set_high(random.uniform(1, 3), 0);
    const bool low = random.uniform() < 0.5;
    const double dx = low ? g.low_x : g.high_x, dy = low ? g.low_y : g.high_y;
    const double along = -g.y / dy + power(random, 1e-3, 3), off = power(random, 1e-12, 1) * (low ? 1 : -1);
    const double px = g.x + along * dx - off * dy, py = g.y + along * dy + off * dx;
    if (py < 0 || (low ? g.inside_low(px, py) : g.inside_high(px, py))) continue;
    const long double more = bend(g, dx, dy, px, py);
    const bool is_reached = low ? g.reaches_low(px, py) : g.reaches_high(px, py);
    if (more > 12 * epsilon) {
      ASSERT_FALSE(is_reached) << i << ": longer by " << static_cast<double>(more);
    }
    if (more < 4 * epsilon && std::abs(off) < 1e-7 * along) {
      ASSERT_TRUE(is_reached) << i << ": longer by " << static_cast<double>(more);
    }
    if (low ? g.inside_high(px, py) : g.inside_low(px, py)) {
      ASSERT_EQ(g.reaches(px, py), is_reached) << i;
    }
    is_reached ? ++reached : ++missed;
  }
  EXPECT_GT(reached, 1000);
  EXPECT_GT(missed, 1000);
}

TEST(SchreiberGenerator, ReachesAllThatItCovers) {
  Random random(4);
  for (int i = 0; i < cases; ++i) {
    const Generator g = random_generator(random);
    const double px = random.uniform(-3, 4), py = random.uniform(-3, 3);
    ASSERT_TRUE(!g.covers(px, py) || g.reaches(px, py)) << i;
  }
}

/// An image far off and hardly below the half-edge: the way bent at the end of what it has is as long as the straight
/// one all along the half-edge, but not off it, and not behind the image.
TEST(SchreiberGenerator, ARayThatGrazesTheHalfEdgeReachesAllOfItBehindItsPlace) {
  for (const double depth : {1e-9, 1e-12, 1e-15}) {
    Generator from_start{-1, -depth, 0, 0, 1, 1, 0, 0, 0}, from_end{2, -depth, 0, -1, 0, 0, 1, 0, 0};
    from_start.set_high(0.5, 0), from_end.set_low(0.5, 0);
    for (const double place : {0.5, 0.6, 1.0}) {
      EXPECT_TRUE(from_start.reaches_high(place, 0)) << depth << " to " << place;
      EXPECT_TRUE(from_end.reaches_low(1 - place, 0)) << depth << " to " << place;
    }
    EXPECT_FALSE(from_start.reaches_high(1, -0.01)) << depth;
    EXPECT_FALSE(from_end.reaches_low(0, -0.01)) << depth;
  }
  const Generator along{0, 0, 0, 0, 1, 1, 0, 0, 0};
  EXPECT_TRUE(along.reaches_high(1, 0) && along.reaches_high(1, 0.5));
  EXPECT_FALSE(along.reaches_high(1, -1e-6));
}

/// However little the ray climbs: what rounding hides is measured along the half-edge.
TEST(SchreiberGenerator, PassesAPlaceIfItsRayMeetsTheHalfEdgeBeyondIt) {
  Random random(5);
  for (int i = 0; i < cases; ++i) {
    Generator g = random_generator(random);
    g.y = -power(random, 1e-12, 2);
    const double place = random.uniform(-1, 2), off = power(random, 1e-14, 1), ray = random.uniform() < 0.5 ? 1 : -1;
    g.set_low(place + ray * off, 0), g.set_high(place + ray * off, 0);
    if (off < 8 * epsilon * (std::abs(place) + std::abs(g.x) - g.y)) continue;
    ASSERT_EQ(g.passes_low(place), ray < 0) << i;
    ASSERT_EQ(g.passes_high(place), ray > 0) << i;
  }
}

TEST(SchreiberGenerator, ARayAimedAtAPlaceDoesNotPassIt) {
  Random random(6);
  for (int i = 0; i < cases; ++i) {
    Generator g = random_generator(random);
    g.y = -power(random, 1e-12, 2);
    const double place = random.uniform(-1, 2);
    g.set_low(place, 0), g.set_high(place, 0);
    ASSERT_FALSE(g.passes_low(place)) << i;
    ASSERT_FALSE(g.passes_high(place)) << i;
  }
}

TEST(SchreiberGenerator, ARayAlongTheHalfEdgeBelowItPassesEveryPlaceOnItsSide) {
  const Generator g{1, -1e-3, 0, -1, 0, 1, 0, 0, 0};
  EXPECT_TRUE(g.passes_low(-100) && g.passes_high(100));
  const Generator away{1, -1e-3, 0, 1, 0, -1, 0, 0, 0};
  EXPECT_FALSE(away.passes_low(-100) || away.passes_high(100));
}

TEST(SchreiberGenerator, AimingAtTheImageItselfLeavesTheRay) {
  Generator g{1, -1, 0, -0.6, 0.8, 0.6, 0.8, 0, 0};
  g.set_low(1 + 1e-12, -1), g.set_high(1, -1 - 1e-12);
  EXPECT_TRUE(g.low_x == -0.6 && g.low_y == 0.8 && g.high_x == 0.6 && g.high_y == 0.8);
  g.set_high(1 + 1e-9, -1);
  EXPECT_NEAR(g.high_x, 1, 1e-15);
  EXPECT_NEAR(g.high_y, 0, 1e-15);
}

TEST(SchreiberGenerator, IsTheSameSeenFromTheOtherSide) {
  Random random(7);
  for (int i = 0; i < cases; ++i) {
    const Generator g = random_generator(random);
    const double length = power(random, 0.1, 2), px = random.uniform(-1, 2), py = random.uniform(0, 2);
    const Generator m = g.mirrored(length);
    ASSERT_NEAR(m.to(length - px, py), g.to(px, py), 20 * epsilon) << i;
    const long double from_low = turn(g, g.low_x, g.low_y, px, py), from_high = turn(g, g.high_x, g.high_y, px, py);
    if (std::abs(from_low) > 1e-10L && std::abs(from_high) > 1e-10L) {
      ASSERT_EQ(m.inside_low(length - px, py), g.inside_high(px, py)) << i;
      ASSERT_EQ(m.inside_high(length - px, py), g.inside_low(px, py)) << i;
    }
    ASSERT_NEAR(m.low(length), length - g.high(length), 20 * epsilon);
    ASSERT_NEAR(m.high(length), length - g.low(length), 20 * epsilon);
    ASSERT_TRUE(m.key == g.key && m.origin == g.origin && m.y == g.y && m.sigma == g.sigma);
  }
}

TEST(SchreiberGenerator, IsTheSameWhereverItIsMoved) {
  Random random(8);
  for (int i = 0; i < cases; ++i) {
    const Generator g = random_generator(random);
    const double angle = random.uniform(0, 7);
    const Motion motion{std::cos(angle), std::sin(angle), random.uniform(-3, 3), random.uniform(-3, 3)};
    const double px = random.uniform(-3, 4), py = random.uniform(-3, 3);
    const Generator moved = g.moved(motion);
    const auto [mx, my] = motion(px, py);
    ASSERT_NEAR(moved.to(mx, my), g.to(px, py), 30 * epsilon) << i;
    ASSERT_TRUE(moved.key == g.key && moved.origin == g.origin && moved.sigma == g.sigma);
    const long double from_low = turn(g, g.low_x, g.low_y, px, py), from_high = turn(g, g.high_x, g.high_y, px, py);
    if (std::abs(from_low) < 1e-10L || std::abs(from_high) < 1e-10L) continue;
    ASSERT_EQ(moved.inside_low(mx, my), g.inside_low(px, py)) << i;
    ASSERT_EQ(moved.inside_high(mx, my), g.inside_high(px, py)) << i;
  }
}

TEST(SchreiberGenerator, IsASliverIfItsRaysAreOneButForRounding) {
  const auto between = [](double low, double high) {
    return Generator{0, 0, 0, std::cos(low), std::sin(low), std::cos(high), std::sin(high), 0, 0};
  };
  for (const double at : {0.5, 1.5, 2.5}) {
    EXPECT_TRUE(between(at, at).is_sliver());
    EXPECT_TRUE(between(at - 1e-9, at).is_sliver()) << "rays that cross";
    EXPECT_FALSE(between(at + 4e-15, at).is_sliver());
  }
  const Generator half_plane{0, 0, 0, -1, 0, 1, 0, 0, 0};
  EXPECT_FALSE(half_plane.is_sliver());
}

}  // namespace
}  // namespace geodrome::schreiber::test
