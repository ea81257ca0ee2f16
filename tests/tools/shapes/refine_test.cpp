// SPDX-License-Identifier: MIT
#include "tools/shapes/refine.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/meshes.hpp"
#include "tools/shapes/meshes.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::shapes {
namespace {

void expect_same_surface(const SurfaceMesh& coarse, const SurfaceMesh& finer) {
  ASSERT_GE(finer.vertex_count(), coarse.vertex_count());
  EXPECT_TRUE(std::ranges::equal(coarse.positions(), finer.positions().first(coarse.vertex_count())));
  EXPECT_NEAR(area(finer), area(coarse), 1e-12 * area(coarse));
  EXPECT_EQ(finer.manifold(), coarse.manifold());
  EXPECT_EQ(finer.oriented(), coarse.oriented());
  EXPECT_EQ(finer.closed(), coarse.closed());
}

TEST(RefineByMidpoints, MakesFourOfEveryFaceUntilThereAreEnough) {
  const SurfaceMesh bumpy = mesh("bumpy", 320), finer = refine_by_midpoints(bumpy, 1281);
  EXPECT_EQ(finer.face_count(), 16 * bumpy.face_count());
  EXPECT_EQ(refine_by_midpoints(bumpy, 1280).face_count(), 4 * bumpy.face_count());
  EXPECT_EQ(refine_by_midpoints(bumpy, 0).face_count(), bumpy.face_count());
  expect_same_surface(bumpy, finer);
}

TEST(RefineByMidpoints, PutsNewVerticesInTheMiddlesOfEdges) {
  const SurfaceMesh one({{0, 0, 0}, {2, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}), finer = refine_by_midpoints(one, 4);
  ASSERT_EQ(finer.vertex_count(), 6u);
  for (const Vec3& middle : {Vec3{1, 0, 0}, Vec3{1, 2, 0}, Vec3{0, 2, 0}})
    EXPECT_NE(std::ranges::find(finer.positions(), middle), finer.positions().end());
}

TEST(RefineByPoints, MakesThreeOfAFaceUntilThereAreEnough) {
  const SurfaceMesh bumpy = mesh("bumpy", 320), finer = refine_by_points(bumpy, 1001, 3);
  EXPECT_EQ(finer.face_count(), 1002u);  // two more a step, from 320
  EXPECT_EQ(finer.vertex_count() - bumpy.vertex_count(), (finer.face_count() - bumpy.face_count()) / 2);
  expect_same_surface(bumpy, finer);
}

TEST(RefineByPoints, IsTheSameForTheSameSeed) {
  const SurfaceMesh torus = mesh("torus", 300);
  EXPECT_TRUE(
      std::ranges::equal(refine_by_points(torus, 900, 5).positions(), refine_by_points(torus, 900, 5).positions()));
  EXPECT_FALSE(
      std::ranges::equal(refine_by_points(torus, 900, 5).positions(), refine_by_points(torus, 900, 6).positions()));
}

TEST(Refine, KeepsBordersAndFansThatTouch) {
  for (const MeshPtr& mesh : {test::plane_grid(3), test::bow_tie(), test::book(), test::moebius(8)}) {
    expect_same_surface(*mesh, refine_by_midpoints(*mesh, 200));
    expect_same_surface(*mesh, refine_by_points(*mesh, 200, 1));
  }
}

}  // namespace
}  // namespace geodrome::shapes
