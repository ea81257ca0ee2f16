// SPDX-License-Identifier: MIT
#include "plugins/common/points/planar_cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace geodrome {
namespace {

HalfPlane toward(double degrees, double offset, Index site) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle), offset, site};
}

TEST(PlanarCell, UncutHasNoEndAndNoVertex) {
  PlanarCell cell;
  cell.reset(10);
  EXPECT_FALSE(cell.bounded());
  EXPECT_FALSE(cell.farthest_real());
  EXPECT_FALSE(cell.farthest_edge());
}

TEST(PlanarCell, ThreeEdgesMakeATriangle) {
  PlanarCell cell;
  cell.reset(10);
  for (Index i = 0; i < 3; ++i) EXPECT_TRUE(cell.cut(toward(120.0 * i, 1, i)));
  EXPECT_EQ(cell.corners().size(), 3U);
  EXPECT_TRUE(cell.bounded());
  EXPECT_NEAR(*cell.farthest_real(), 2, 1e-14);
}

TEST(PlanarCell, AStripHasNoVertexButAnEdge) {
  PlanarCell cell;
  cell.reset(10);
  cell.cut(toward(0, 1, 0));
  cell.cut(toward(180, 3, 1));
  EXPECT_FALSE(cell.farthest_real());
  EXPECT_EQ(cell.farthest_edge(), 3);
}

TEST(PlanarCell, AHalfStripKeepsItsRealVertices) {
  PlanarCell cell;
  cell.reset(10);
  cell.cut(toward(0, 3, 0));
  cell.cut(toward(180, 3, 1));
  cell.cut(toward(90, 4, 2));
  EXPECT_FALSE(cell.bounded());
  EXPECT_NEAR(*cell.farthest_real(), 5, 1e-14);
}

TEST(PlanarCell, AVertexBeyondReachDoesNotCount) {
  PlanarCell cell;
  cell.reset(10);
  cell.cut(toward(0, 8, 0));
  cell.cut(toward(90, 8, 1));  // crosses the other at a distance of 11.3, inside the starting square
  cell.cut(toward(180, 1, 2));
  cell.cut(toward(270, 1, 3));
  EXPECT_FALSE(cell.bounded());
  EXPECT_NEAR(*cell.farthest_real(), std::hypot(8, 1), 1e-14);
}

TEST(PlanarCell, AnEdgeWithoutEndHasNoneAfterASecondCutByTheSameLine) {
  PlanarCell cell;
  for (int degrees = 0; degrees < 360; ++degrees) {
    cell.reset(10);
    cell.cut(toward(degrees, 1, 0));
    cell.cut(toward(degrees + 90, 1, 1));
    HalfPlane again = toward(degrees, 1 - 1e-15, 2);
    again.nx += 1e-15;
    cell.cut(again);
    ASSERT_NEAR(*cell.farthest_real(), std::numbers::sqrt2, 1e-14);
    ASSERT_FALSE(cell.bounded());
  }
}

TEST(PlanarCell, ALineBeyondTheFarthestCornerCutsNothing) {
  PlanarCell cell;
  cell.reset(1);
  EXPECT_FALSE(cell.cut(toward(45, 3, 0)));
}

TEST(PlanarCell, ACellCutTwiceByTheSameLineStaysAsItIs) {
  PlanarCell cell;
  cell.reset(10);
  for (Index i = 0; i < 7; ++i) cell.cut(toward(360.0 / 7 * i, 1, i));
  const double before = *cell.farthest_real();
  for (Index i = 0; i < 7; ++i) cell.cut(toward(360.0 / 7 * i, 1, i));
  EXPECT_NEAR(*cell.farthest_real(), before, 1e-14);
}

TEST(PlanarCell, NearlyParallelEdgesLeaveAFiniteCell) {
  PlanarCell cell;
  cell.reset(10);
  for (Index i = 0; i < 4; ++i) cell.cut(toward(90.0 * i, 1, i));
  cell.cut({std::cos(1e-13), std::sin(1e-13), 1 - 1e-14, 4});
  EXPECT_NEAR(*cell.farthest_real(), std::numbers::sqrt2, 1e-12);
}

}  // namespace
}  // namespace geodrome
