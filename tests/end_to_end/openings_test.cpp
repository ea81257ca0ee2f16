// SPDX-License-Identifier: MIT
// Openings of a sample that the surface closes, through the program.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/scans.hpp"
#include "tools/shapes/random.hpp"

namespace {

using namespace geodrome;
using namespace geodrome::testing;
using shapes::Random;

class Openings : public ::testing::Test {
 protected:
  Outcome run(const std::vector<Vec3>& points) {
    write_points(folder_ / "s.ply", points);
    return run_geodrome(folder_, {"distances", (folder_ / "s.ply").string(), "--sources", "0", "-o",
                                  (folder_ / "d.npy").string(), "--quiet"});
  }
  /// What the program says of a sample.
  std::string told(const std::vector<Vec3>& points) {
    const Outcome outcome = run(points);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }
  static bool is_told(const std::string& text) {
    return text.find("practice   doubtful: ") != std::string::npos &&
           text.find("the surface spans a place without points, ") != std::string::npos;
  }

  TemporaryFolder folder_;
};

/// Points of the unit sphere below a height.
std::vector<Vec3> cup(std::size_t count, double height, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  while (points.size() < count) {
    const double z = random.uniform(-1, height), turn = random.uniform(0, 2 * std::numbers::pi);
    points.push_back({std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z});
  }
  return points;
}

TEST_F(Openings, ThatAreRoundAreToldWhereTheyAreClosed) {
  std::size_t closed = 0;
  for (const double height : {0.95, 0.9, 0.8})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const std::string text = told(cup(1000, height, seed));
      if (text.find(", closed, ") == std::string::npos) continue;
      EXPECT_TRUE(is_told(text)) << "height " << height << ", seed " << seed << ": " << text;
      ++closed;
    }
  EXPECT_GT(closed, 3U);
}

TEST_F(Openings, OfAPipeScannedInLinesAreTold) {
  std::vector<Vec3> points;
  for (int line = 0; line < 16; ++line)
    for (int i = 0; i < 70; ++i) {
      const double turn = 2 * std::numbers::pi * line / 16;
      points.push_back({std::cos(turn), std::sin(turn), i / 17.5});
    }
  EXPECT_TRUE(is_told(told(points)));
}

TEST_F(Openings, ThatTearASurfaceApartAreTold) {
  std::size_t torn = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    std::vector<Vec3> strip;
    for (int i = 0; i < 80; ++i) strip.push_back({random.uniform(0, 6), random.uniform(0, 0.7), 0});
    const Outcome outcome = run(strip);
    const std::string& text = outcome.out;
    if (outcome.status == 4 || text.find(", 1 component, ") != std::string::npos) continue;
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(text.find("practice   doubtful: "), std::string::npos) << text;
    EXPECT_NE(text.find(" are neighbours, but on parts of the surface that do not meet"), std::string::npos) << text;
    ++torn;
  }
  EXPECT_GT(torn, 0U);
}

TEST_F(Openings, OfTwoSpheresApartAreNone) {
  std::vector<Vec3> points = cup(800, 1, 1);
  for (const Vec3& p : cup(800, 1, 2)) points.push_back(p + Vec3{2.5, 0, 0});
  const std::string text = told(points);
  EXPECT_NE(text.find(", 2 components"), std::string::npos) << text;
  EXPECT_EQ(text.find("do not meet"), std::string::npos) << text;
}

TEST_F(Openings, AreNotSeenWhereChanceLeavesGaps) {
  for (const std::size_t count : {600U, 2000U, 6000U})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const std::string text = told(cup(count, 1, seed));
      EXPECT_EQ(text.find("spans a place"), std::string::npos) << count << " points, seed " << seed << ": " << text;
    }
}

}  // namespace
