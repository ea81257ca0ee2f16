// SPDX-License-Identifier: MIT
#include "plugins/reconstructor_delaunay_cut/sheet_fans.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace geodrome {
namespace {

/// A hub at 0 and six points around it, 1 to 6, counter-clockwise; 7 and 8 lie farther off, beyond 1 and 2.
struct Wheel {
  std::vector<Vec3> points{{0, 0, 0}};
  std::vector<Vec3> normals;

  Wheel() {
    for (int i = 0; i < 6; ++i) {
      const double angle = std::numbers::pi / 3 * i;
      points.push_back({std::cos(angle), std::sin(angle), 0});
    }
    points.push_back({2, 0.4, 0}), points.push_back({1, 1.8, 0});
    for (std::size_t i = 0; i < points.size(); ++i) normals.push_back({0, 0, i % 2 == 0 ? 1.0 : -1.0});
  }
};

TEST(SheetFans, TakesTrianglesThatLieSideBySideWhateverTheNormalsSigns) {
  const Wheel wheel;
  SheetFans fans(wheel.points, wheel.normals);
  for (Index i = 1; i <= 6; ++i) {
    const Triangle spoke{0, i, i % 6 + 1};
    ASSERT_TRUE(fans.fits(spoke)) << i;
    fans.add(spoke);
  }
  EXPECT_TRUE(fans.gaps(0).empty()) << "the hub is inside";
  EXPECT_EQ(fans.gaps(1).size(), 1u);
  EXPECT_EQ(fans.faces_at(0, 1), 2);
  EXPECT_EQ(fans.faces_at(1, 2), 1);
}

TEST(SheetFans, RefusesWhatFoldsOver) {
  const Wheel wheel;
  SheetFans fans(wheel.points, wheel.normals);
  fans.add({0, 1, 3});
  EXPECT_FALSE(fans.fits({0, 1, 3})) << "the same again";
  EXPECT_FALSE(fans.fits({0, 1, 2})) << "on top of it";
  EXPECT_FALSE(fans.fits({0, 2, 4})) << "its edge to 2 starts inside";
  EXPECT_TRUE(fans.fits({0, 3, 5}));
  EXPECT_TRUE(fans.fits({1, 2, 3})) << "across its far edge";
}

TEST(SheetFans, RefusesEdgesThatCrossThoseOfNeighbours) {
  const Wheel wheel;
  SheetFans fans(wheel.points, wheel.normals);
  fans.add({0, 1, 2});
  fans.add({1, 2, 8});
  EXPECT_FALSE(fans.fits({0, 7, 8})) << "from the hub across the first";
  EXPECT_FALSE(fans.fits({7, 2, 3})) << "from 7 to 3 across both";
  EXPECT_TRUE(fans.fits({1, 7, 8}));
}

TEST(SheetFans, RefusesTrianglesWithoutAnArea) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, normals(3, {0, 0, 1});
  EXPECT_FALSE(SheetFans(points, normals).fits({0, 1, 2}));
}

TEST(SheetFans, TellsTheGapsWhereFansMeetInAPoint) {
  const Wheel wheel;
  SheetFans fans(wheel.points, wheel.normals);
  fans.add({0, 1, 2});
  fans.add({0, 4, 5});
  const std::vector<SheetFans::Gap> gaps = fans.gaps(0);
  ASSERT_EQ(gaps.size(), 2u);
  for (const auto& [from, to] : gaps) EXPECT_TRUE((from == 2 && to == 4) || (from == 5 && to == 1)) << from << to;
}

}  // namespace
}  // namespace geodrome
