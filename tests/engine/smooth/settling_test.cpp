// SPDX-License-Identifier: MIT
#include "engine/smooth/settling.hpp"

#include <gtest/gtest.h>

#include "geodrome/engine/surface_locator.hpp"
#include "tests/engine/smooth/smooth_fixture.hpp"

namespace geodrome::test {
namespace {

/// The surface points that are closest to points of a shape on the triangles.
std::vector<SettledPoint> points_above(const MeshPtr& mesh, const Star& star, int count) {
  std::mt19937_64 random(5);
  const SurfaceLocator locator(mesh);
  std::vector<SettledPoint> points;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = onto(star, mesh->position(random_point(*mesh, random)));
    points.push_back({p, locator.closest(p).at});
  }
  return points;
}

TEST(Settling, FindsWhereThePointIs) {
  const MeshPtr mesh = mesh_of(Star{}, 1280);
  const Measured<Star> star(mesh);
  std::vector<SettledPoint> points = points_above(mesh, Star{}, 400);
  double flat = 0;
  for (const SettledPoint& point : points)
    flat = std::max(flat, distance(onto(Star{}, mesh->position(point.at)), point.position));
  EXPECT_GT(flat, 1e-4);
  settle(star.charts, points);
  for (const SettledPoint& point : points) {
    EXPECT_LT(distance(onto(Star{}, mesh->position(point.at)), point.position), 1e-12);
    for (const double b : point.at.b) EXPECT_GE(b, 0);
    EXPECT_NEAR(point.at.b[0] + point.at.b[1] + point.at.b[2], 1, 1e-14);
  }
}

TEST(Settling, StaysOnFacesThatAreNotTrusted) {
  const MeshPtr mesh = mesh_of(Star{}, 1280);
  const Measured<Star> star(mesh, {}, [](Index face) { return face % 2 ? 0 : infinity; });
  std::vector<SettledPoint> points = points_above(mesh, Star{}, 200);
  const std::vector<SettledPoint> before = points;
  settle(star.charts, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].at.face % 2, before[i].at.face % 2);
    EXPECT_TRUE(before[i].at.face % 2 == 1 || points[i].at == before[i].at);
  }
}

}  // namespace
}  // namespace geodrome::test
