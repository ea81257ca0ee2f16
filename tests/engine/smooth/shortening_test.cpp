// SPDX-License-Identifier: MIT
// What holds of every path: both directions, poses, faces that stay flat, and paths of the shapes that are easily
// forgotten.
#include "engine/smooth/shortening.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geodrome/engine/surface_locator.hpp"
#include "tests/engine/smooth/smooth_fixture.hpp"

namespace geodrome::test {
namespace {

using Sphere = Ellipsoid;

double arc(const Vec3& p, const Vec3& q) { return std::atan2(norm(cross(p, q)), dot(p, q)); }

/// The arc between the points of the unit sphere above two points of a mesh.
double arc(const SurfaceMesh& mesh, const SurfacePoint& p, const SurfacePoint& q) {
  return arc(mesh.position(p), mesh.position(q));
}

MeshPtr sphere_mesh() { return mesh_of(Sphere{}, 1280); }

TEST(Shortening, GivesOneLengthFromBothEnds) {
  Measured<Star> star(mesh_of(Star{}, 5120));
  for (const auto& [from, to] : vertex_pairs(*star.mesh, 40, 0.3)) {
    const double there = star.between(from, to).length;
    Path back = star.flat.find(from, to).second;
    std::ranges::reverse(back);
    EXPECT_NEAR(star.shorten(back).length, there, 1e-13 * there);
    EXPECT_NEAR(star.between(to, from).length, there, 1e-12 * there) << "the flat paths differ by rounding";
  }
}

TEST(Shortening, IsTheSameInEveryPose) {
  const Pose pose{.turned = true, .scale = 1e-3, .shift = {3, -2, 7}};
  const MeshPtr mesh = mesh_of(Star{}, 1280);
  Measured<Star> star(mesh);
  Measured<Star> other(mapped(mesh, [&](const Vec3& p) { return pose.point(p); }), {}, {}, pose);
  for (const auto& [from, to] : vertex_pairs(*mesh, 20, 0.3)) {
    const SmoothLength a = star.between(from, to), b = other.between(from, to);
    EXPECT_NEAR(b.length, 1e-3 * a.length, 1e-10 * a.length * 1e-3) << "coordinates are rounded at 7";
    EXPECT_EQ(a.moved, b.moved);
  }
}

TEST(Shortening, LeavesPathsInAPlaneAsTheyAre) {
  Measured<Plane> plane(shaken(plane_grid(8, true), 0, 1));
  for (const auto& [from, to] : vertex_pairs(*plane.mesh, 20, 0.5)) {
    const SmoothLength found = plane.between(from, to);
    EXPECT_NEAR(found.length, distance(plane.mesh->position(from), plane.mesh->position(to)), 1e-13);
    EXPECT_TRUE(found.moved);
  }
}

TEST(Shortening, LeavesFlatWhatIsNotTrusted) {
  Measured<Sphere> sphere(sphere_mesh(), {}, [](Index) { return infinity; });
  for (const auto& [from, to] : vertex_pairs(*sphere.mesh, 10, 0.5)) {
    const auto [flat, path] = sphere.flat.find(from, to);
    const SmoothLength found = sphere.shorten(path);
    EXPECT_NEAR(found.length, flat, 1e-14);
    EXPECT_EQ(found.smooth, 0);
  }
}

TEST(Shortening, TakesTheSmoothLengthOfRunsAndTheFlatOneBetweenThem) {
  const MeshPtr mesh = sphere_mesh();
  const auto in_belt = [&](Index face) {
    const auto [p, q, r] = mesh->corners(face);
    return std::abs(p.z + q.z + r.z) < 0.6;
  };
  Measured<Sphere> sphere(mesh, {}, [&](Index face) { return in_belt(face) ? infinity : 0; });
  int crossing = 0;
  for (const auto& [from, to] : vertex_pairs(*mesh, 30, 1.2)) {
    const auto [flat, path] = sphere.flat.find(from, to);
    const SmoothLength found = sphere.shorten(path);
    EXPECT_NEAR(found.flat, flat, 1e-14);
    const double truth = arc(*mesh, from, to), share = found.smooth / found.flat;
    if (share == 0 || share == 1) continue;
    ++crossing;
    // Of what the flat path is too short by, the share of the runs is regained, as evenly as the faces are alike.
    const double regained = (found.length - flat) / (truth - flat);
    EXPECT_NEAR(regained, share, 0.15);
    std::vector<SurfacePoint> points;
    std::vector<Vec3> curve;
    sphere.shortening.curve(0, points, curve);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_TRUE(in_belt(points[i].face) || std::abs(norm(curve[i]) - 1) < 1e-14);
  }
  EXPECT_GE(crossing, 10);
}

TEST(Shortening, WorksWithinOneFace) {
  const MeshPtr mesh = sphere_mesh();
  Measured<Sphere> sphere(mesh);
  const SurfacePoint p{5, {0.2, 0.3, 0.5}}, q{5, {0.6, 0.3, 0.1}};
  const SmoothLength found = sphere.between(p, q);
  EXPECT_NEAR(found.length, arc(*mesh, p, q), 1e-10);
  EXPECT_GT(found.length, found.flat);
}

TEST(Shortening, OfPointsMuchNearerThanAnEdgeIsTheirDistance) {
  Measured<Sphere> sphere(sphere_mesh());
  for (const double apart : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const SurfacePoint p{5, {0.2, 0.3, 0.5}}, q{5, {0.2 + apart, 0.3, 0.5 - apart}};
    const SmoothLength found = sphere.shorten({p, q});
    EXPECT_NEAR(found.length, arc(*sphere.mesh, p, q), 1e-15 + 1e-9 * apart);
  }
}

TEST(Shortening, OfAPointToItselfIsZero) {
  Measured<Sphere> sphere(sphere_mesh());
  const SurfacePoint vertex = sphere.mesh->at_vertex(17), inside{5, {0.2, 0.3, 0.5}};
  for (const SurfacePoint& point : {vertex, inside}) {
    EXPECT_EQ(sphere.between(point, point).length, 0);
    EXPECT_EQ(sphere.shorten({point}).length, 0);
    EXPECT_EQ(sphere.shorten({point, point}).length, 0);
  }
}

TEST(Shortening, BeginsAndEndsInsideFaces) {
  const MeshPtr mesh = sphere_mesh();
  Measured<Sphere> sphere(mesh);
  std::mt19937_64 random(3);
  for (int k = 0; k < 30; ++k) {
    const SurfacePoint p = random_point(*mesh, random), q = random_point(*mesh, random);
    const double truth = arc(*mesh, p, q);
    if (truth > 3) continue;  // many ways around
    EXPECT_NEAR(sphere.between(p, q).length, truth, 1e-6 * truth);
  }
}

TEST(Shortening, GoesThroughVerticesAndAlongEdges) {
  const MeshPtr mesh = sphere_mesh();
  Measured<Sphere> sphere(mesh);
  for (const Index vertex : {20u, 40u, 60u}) {
    const SurfacePoint middle = mesh->at_vertex(vertex);
    const Index h = mesh->first_half_edge(vertex);
    const SurfacePoint first = mesh->at_vertex(mesh->to(h));
    EXPECT_NEAR(sphere.shorten({first, middle}).length, arc(*mesh, first, middle), 1e-9);
    Index across = h;  // the edge on the other side of six, nearly straight on
    for (int k = 0; k < 3; ++k) across = mesh->twins()[SurfaceMesh::previous(across)];
    const SurfacePoint last = mesh->at_vertex(mesh->to(across));
    EXPECT_NEAR(sphere.shorten({first, middle, last}).length, arc(*mesh, first, last), 1e-6);
  }
}

TEST(Shortening, TakesTheTrustedSideOfAnEdge) {
  const MeshPtr mesh = sphere_mesh();
  for (const Index h : {30u, 31u, 32u}) {
    const Index other = mesh->twins()[h] / 3, own = h / 3;
    const SurfacePoint p = mesh->at_vertex(mesh->from(h)), q = mesh->at_vertex(mesh->to(h));
    for (const Index trusted : {own, other}) {
      Measured<Sphere> sphere(mesh, {}, [&](Index face) { return face == trusted ? 0 : infinity; });
      const SmoothLength found = sphere.shorten({p, q});
      EXPECT_EQ(found.smooth, found.flat);
      EXPECT_NEAR(found.length, arc(*mesh, p, q), 1e-9);
    }
  }
}

TEST(Shortening, DoesNotDependOnWhatElseIsInTheBatch) {
  Measured<Star> star(mesh_of(Star{}, 1280));
  const auto pairs = vertex_pairs(*star.mesh, 20, 0.1);
  std::vector<double> alone;
  for (const auto& [from, to] : pairs) alone.push_back(star.between(from, to).length);
  for (const auto& [from, to] : pairs) star.shortening.add(star.flat.find(from, to).second);
  const auto together = star.shortening.run();
  ASSERT_EQ(together.size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(together[i].length, alone[i]);
}

TEST(Shortening, StaysWhereTheCurveIsNoNeighbourOfAShortestOne) {
  const MeshPtr mesh = sphere_mesh();
  Measured<Sphere> sphere(mesh);
  // Two thirds of the equator, of three paths that are shortest each.
  Path around;
  const SurfaceLocator locator(mesh);
  const auto near = [&](double angle) { return locator.closest({std::cos(angle), std::sin(angle), 0.01}).at; };
  for (int k = 0; k < 3; ++k) {
    const Path part = sphere.flat.find(near(1.4 * k), near(1.4 * (k + 1))).second;
    around.insert(around.end(), part.begin() + (k > 0), part.end());
  }
  const SmoothLength found = sphere.shorten(around);
  EXPECT_FALSE(found.moved);
  EXPECT_NEAR(found.length, 4.2, 0.01);
}

TEST(Shortening, EstimatesWhatTheSurfaceMayBeOffBy) {
  const MeshPtr mesh = sphere_mesh();
  Measured<Sphere> sphere(mesh, {}, [](Index) { return 1e-3; });
  const auto [from, to] = vertex_pairs(*mesh, 1, 1.2)[0];
  const SmoothLength found = sphere.between(from, to);
  const double lifted = 1e-3 * found.length;  // by so much is the arc longer on a sphere 1e-3 larger
  EXPECT_LT(found.error.value(), 0.25 * lifted) << "not all pieces are off to one side";
  EXPECT_GT(found.error.value(), 0.02 * lifted);
}

TEST(Shortening, EstimatesWhatFlatFacesAreOffBy) {
  Measured<Sphere> sphere(sphere_mesh(), {}, [](Index) { return infinity; });
  double off = 0, estimate = 0;
  for (const auto& [from, to] : vertex_pairs(*sphere.mesh, 30, 0.5)) {
    const SmoothLength found = sphere.between(from, to);
    off += arc(*sphere.mesh, from, to) - found.length, estimate += found.error.value();
  }
  EXPECT_GT(estimate, off / 4) << "where triangles are alike, normals turn less than in others";
  EXPECT_LT(estimate, 4 * off);
}

TEST(Shortening, RefusesAStepThatLiesInNoFace) {
  Measured<Sphere> sphere(sphere_mesh());
  EXPECT_THROW(sphere.shorten({sphere.mesh->at_vertex(0), sphere.mesh->at_vertex(1)}), NumericalError);
}

}  // namespace
}  // namespace geodrome::test
