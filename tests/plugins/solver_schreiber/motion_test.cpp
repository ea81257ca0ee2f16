// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/plugins/solver_schreiber/rows.hpp"

namespace geodrome::schreiber::test {
namespace {

void expect_place(const std::pair<double, double>& place, double x, double y, double tolerance) {
  EXPECT_NEAR(place.first, x, tolerance);
  EXPECT_NEAR(place.second, y, tolerance);
}

TEST(SchreiberMotion, TurnsThenShifts) {
  const Motion quarter{0, 1, 10, 20};
  EXPECT_EQ(quarter.turn(1, 2), std::pair(-2.0, 1.0));
  EXPECT_EQ(quarter.turn_back(-2, 1), std::pair(1.0, 2.0));
  EXPECT_EQ(quarter(1, 2), std::pair(8.0, 21.0));
  EXPECT_EQ(Motion()(1, 2), std::pair(1.0, 2.0));
}

TEST(SchreiberMotion, AProductIsTheRightOneThenTheLeftOne) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Motion a = any_motion(random), b = any_motion(random), c = any_motion(random);
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const auto [cx, cy] = c(x, y);
    const auto [bx, by] = b(cx, cy);
    const auto [ax, ay] = a(bx, by);
    // No number is above 6, and a few roundings make each.
    expect_place((a * b * c)(x, y), ax, ay, 100 * epsilon);
    expect_place((a * (b * c))(x, y), ax, ay, 100 * epsilon);
  }
}

TEST(SchreiberMotion, TheInverseUndoesItFromBothSides) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Motion motion = any_motion(random);
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const auto [mx, my] = motion(x, y);
    expect_place(motion.inverse()(mx, my), x, y, 50 * epsilon);
    expect_place((motion.inverse() * motion)(x, y), x, y, 50 * epsilon);
    expect_place((motion * motion.inverse())(x, y), x, y, 50 * epsilon);
    const auto [tx, ty] = motion.turn(x, y);
    expect_place(motion.turn_back(tx, ty), x, y, 50 * epsilon);
  }
}

TEST(SchreiberMotion, StaysRigidInAMillionProducts) {
  Random random(3);
  Motion from_left, from_right;
  for (int i = 0; i < 1000000; ++i) {
    const Motion next = any_motion(random);
    from_left = next * from_left, from_right = from_right * next;
    for (const Motion& motion : {from_left, from_right})
      ASSERT_NEAR(std::hypot(motion.cosine, motion.sine), 1, 4 * epsilon) << "after " << i;
  }
}

TEST(SchreiberMotion, ComesBackAfterAMillionStepsAlongACircle) {
  constexpr int steps = 1000000;
  // About the point (1, 0), which stays; a step rounds the angle by two epsilon at most and numbers up to 2 a few
  // times.
  const double angle = 2 * std::numbers::pi / steps;
  const Motion step = turned(angle, 1 - std::cos(angle), -std::sin(angle));
  Motion motion;
  for (int i = 0; i < steps; ++i) motion = step * motion;
  expect_place(motion(1, 0), 1, 0, 10 * steps * epsilon);
  expect_place(motion(0, 0), 0, 0, 10 * steps * epsilon);
}

TEST(SchreiberMotion, ARotationOfTheWrongLengthIsBroughtBack) {
  Motion motion = turned(0.5, 0, 0);
  motion.cosine *= 1.001, motion.sine *= 1.001;
  for (int i = 0; i < 3; ++i) motion = motion * Motion();
  EXPECT_NEAR(std::hypot(motion.cosine, motion.sine), 1, 4 * epsilon);
  EXPECT_NEAR(std::atan2(motion.sine, motion.cosine), 0.5, 4 * epsilon);
}

}  // namespace
}  // namespace geodrome::schreiber::test
