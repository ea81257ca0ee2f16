// SPDX-License-Identifier: MIT
// What a march is made of: spreading geodesics, directions, rays, curves above edges, distances along them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/smooth/fronts/arrival.hpp"
#include "engine/smooth/fronts/crossing.hpp"
#include "engine/smooth/fronts/ray.hpp"
#include "engine/smooth/fronts/spread.hpp"
#include "tests/engine/smooth/smooth_fixture.hpp"

namespace geodrome::test {
namespace {

TEST(Spread, IsThatOfGreatCirclesAndOfLines) {
  Spread round{0, 1}, straight{0, 1};
  for (int i = 0; i < 20; ++i) round = round.after(0.1, {1, 1, 1}), straight = straight.after(0.1, {0, 0, 0});
  EXPECT_NEAR(round.apart, std::sin(2.0), 1e-5);
  EXPECT_NEAR(round.slope, std::cos(2.0), 1e-5);
  EXPECT_NEAR(straight.apart, 2, 1e-14);
}

TEST(Spread, GrowsOnSaddles) {
  Spread spread{0, 1};
  for (int i = 0; i < 20; ++i) spread = spread.after(0.1, {-1, -1, -1});
  EXPECT_NEAR(spread.apart, std::sinh(2.0), 1e-4);
}

/// A helix on the cylinder of radius 1: a geodesic with torsion.
struct Helix {
  double slope, length;  // from 0
  Vec3 point(double s) const {
    const double c = std::cos(slope);
    return {std::cos(c * s), std::sin(c * s), std::sin(slope) * s};
  }
  Vec3 normal(double s) const { return {std::cos(std::cos(slope) * s), std::sin(std::cos(slope) * s), 0}; }
  Vec3 tangent(double s) const {
    const double c = std::cos(slope);
    return {-c * std::sin(c * s), c * std::cos(c * s), std::sin(slope)};
  }
  Vec3 chord() const { return (point(length) - point(0)) / norm(point(length) - point(0)); }
  double error() const { return norm(arriving(chord(), normal(0), normal(length)).along - tangent(length)); }
  double finer_error() const {
    // the normal turns with the circle, not along the axis
    const Vec3 n = normal(length), around{-n.y, n.x, 0};
    const std::array<Vec3, 3> turn{around.x * around, around.y * around, Vec3{}};
    return norm(arriving(chord(), length, normal(0), n, turn) - tangent(length));
  }
};

TEST(Arrival, KnowsTheTorsionOfAHelix) {
  const Helix long_piece{0.6, 0.2}, half{0.6, 0.1};
  const Vec3 n = long_piece.normal(0.2), chord = long_piece.chord(), flat = chord - dot(chord, n) * n;
  EXPECT_GT(norm(flat / norm(flat) - long_piece.tangent(0.2)), 1e-3) << "the chord knows nothing of it";
  EXPECT_LT(long_piece.error(), 1e-4);
  EXPECT_GT(std::log2(long_piece.error() / half.error()), 2.8);
  EXPECT_LT(long_piece.finer_error(), 2e-5);
  EXPECT_GT(std::log2(long_piece.finer_error() / half.finer_error()), 3.5);
}

TEST(Ray, GoesStraightOverAPlane) {
  const MeshPtr mesh = shaken(plane_grid(6, true), 0, 2);
  const SurfacePoint from{10, {0.3, 0.3, 0.4}};
  const Vec3 direction{0.8, 0.6, 0};
  auto ray = ray_from(*mesh, from, direction);
  int faces = 0;
  for (; ray; ray = next_face(*mesh, *ray), ++faces) {
    const Vec3 a = mesh->positions()[mesh->from(ray->half_edge)], b = mesh->positions()[mesh->to(ray->half_edge)];
    const Vec3 way = a + ray->share * (b - a) - mesh->position(from);
    EXPECT_NEAR(norm(cross(way, direction)), 0, 1e-12);
    EXPECT_GT(dot(way, direction), 0);
  }
  EXPECT_GE(faces, 3) << "up to the border";
}

TEST(Ray, LeavesAVertexIntoTheFaceThatHoldsIt) {
  const MeshPtr mesh = shaken(plane_grid(6, true), 0, 2);
  const SmoothCharts charts(mesh, std::make_shared<const AnalyticSurface<Plane>>(mesh));
  const EdgeCurves curves(charts);
  const auto from_middle = [](const Vec3& p) { return distance(p, {3, 3, 0}); };
  const Index inner =
      static_cast<Index>(std::ranges::min_element(mesh->positions(), {}, from_middle) - mesh->positions().begin());
  for (int k = 0; k < 16; ++k) {
    const Vec3 direction{std::cos(0.4 * k + 0.1), std::sin(0.4 * k + 0.1), 0};
    const auto ray = ray_from(*mesh, curves.starting_at(inner), direction);
    ASSERT_TRUE(ray);
    const Vec3 a = mesh->positions()[mesh->from(ray->half_edge)], b = mesh->positions()[mesh->to(ray->half_edge)];
    const Vec3 way = a + ray->share * (b - a) - mesh->positions()[inner];
    EXPECT_NEAR(norm(cross(way, direction)), 0, 1e-12);
    EXPECT_GT(dot(way, direction), 0);
  }
}

TEST(EdgeCurves, LieOnTheSurfaceWithItsNormalsAndCurvature) {
  const Ellipsoid shape{0.8, 0.6};
  const MeshPtr mesh = mesh_of(shape, 1280);
  const SmoothCharts charts(mesh, std::make_shared<const AnalyticSurface<Ellipsoid>>(mesh, shape));
  const EdgeCurves curves(charts);
  for (Index h = 0; h < 3 * mesh->face_count(); ++h) {
    for (const double share : {0.0, 0.13, 0.5, 0.77, 1.0}) {
      const CurvePoint at = curves.edge(h).at(share);
      EXPECT_LT(distance(onto(shape, at.position), at.position), 1e-7);
      const Vector<double> g = shape.gradient(Vector<double>{at.position.x, at.position.y, at.position.z});
      const Vec3 normal = Vec3{g.x, g.y, g.z} / norm(Vec3{g.x, g.y, g.z});
      EXPECT_LT(norm(at.normal - normal), 1e-5);
      EXPECT_NEAR(dot(at.first, normal) / norm(at.first), 0, 1e-5);
    }
  }
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const Vec3 p = mesh->positions()[v];  // K = (b c (x^2 + y^2 / b^4 + z^2 / c^4))^-2
    const double w = p.x * p.x + p.y * p.y / std::pow(0.8, 4) + p.z * p.z / std::pow(0.6, 4);
    EXPECT_NEAR(curves.vertex(v).curvature, std::pow(0.48 * w, -2), 1e-9);
    EXPECT_NEAR(curves.curvature(mesh->at_vertex(v)), curves.vertex(v).curvature, 1e-12);
  }
}

TEST(EdgeFront, IsExactInAPlane) {
  EdgeCurve curve;
  const Vec3 a{1, 2, 0}, b{2, 1.5, 0}, source{-0.3, 0.2, 0};
  curve.position[0] = a, curve.position[1] = b - a, curve.normal[0] = {0, 0, 1}, curve.length = distance(a, b);
  const auto point = [&](const Vec3& p) {
    return FrontPoint{.distance = distance(p, source), .gradient = (p - source) / distance(p, source), .bend = 1};
  };
  const EdgeFront front(curve, point(a), point(b));
  for (const double share : {0.0, 0.3, 0.6, 1.0})
    EXPECT_NEAR(front.at(share).value, distance(a + share * (b - a), source), 1e-14);
  const Vec3 to{2.5, 2.5, 0}, up{0, 0, 1};
  const auto crossing = find_crossing(front, {to, up}, 0.5);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->distance, distance(to, source), 1e-9);
  const Vec3 behind{0.2, 0.3, 0};
  EXPECT_FALSE(find_crossing(front, {behind, up}, 0.5)) << "the source is on this side of the edge";
}

TEST(EdgeFront, DoubtsEndsThatAreReachedByDifferentWays) {
  EdgeCurve curve;
  curve.position[0] = {-0.1, 0, 0}, curve.position[1] = {0.2, 0, 0}, curve.normal[0] = {0, 0, 1}, curve.length = 0.2;
  const FrontPoint left{.distance = 1, .gradient = {0.6, 0.8, 0}, .bend = 1};
  const FrontPoint right{.distance = 1, .gradient = {-0.6, 0.8, 0}, .bend = 1};
  EXPECT_GT(EdgeFront(curve, left, right).doubt(), 0.01);
}

}  // namespace
}  // namespace geodrome::test
