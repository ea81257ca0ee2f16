// SPDX-License-Identifier: MIT
#include "engine/smooth/settling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(Settling, PutsPointsBeyondABorderOntoItsClosestPoint) {
  // The smooth surface is the unit square itself. Two thirds of the points are where no face is.
  class Square : public SmoothSurface {
   public:
    explicit Square(MeshPtr mesh) : mesh_(std::move(mesh)) {}
    double deviation(Index) const override { return 0; }
    void evaluate(std::span<const SmoothPlace> places, std::span<SmoothPoint> points) const override {
      for (std::size_t i = 0; i < places.size(); ++i)
        points[i] = {mesh_->position(places[i].at), {0, 0, 1}, places[i].direction, {}, {}};
    }
    std::size_t bytes() const override { return sizeof *this; }

   private:
    MeshPtr mesh_;
  };
  const MeshPtr mesh = plane_grid(5);
  const SmoothCharts charts(mesh, std::make_shared<const Square>(mesh));
  const SurfaceLocator locator(mesh);
  const Vec3 corner = *std::ranges::max_element(mesh->positions(), {}, [](const Vec3& p) { return p.x + p.y; });
  std::mt19937_64 random(5);
  std::vector<SettledPoint> points;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p{(1.6 * uniform(random) - 0.3) * corner.x, (1.6 * uniform(random) - 0.3) * corner.y, 0};
    points.push_back({p, locator.closest(p).at});
  }
  settle(charts, points);
  for (const SettledPoint& point : points) {
    const Vec3& p = point.position;
    const Vec3 closest{std::clamp(p.x, 0.0, corner.x), std::clamp(p.y, 0.0, corner.y), 0};
    EXPECT_LT(distance(mesh->position(point.at), closest), 1e-14 * norm(corner));
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
