// SPDX-License-Identifier: MIT
// Distances that are carried over a smooth surface against formulas and against paths that are shortened one by one.
#include "engine/smooth/fronts/march.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/smooth/fronts/path_end.hpp"
#include "tests/engine/smooth/smooth_fixture.hpp"

namespace geodrome::test {
namespace {

using Sphere = Ellipsoid;

/// A march from a vertex of a shape's mesh.
template <class Shape>
class Marched : public Measured<Shape> {
 public:
  template <class... Arguments>
  explicit Marched(MeshPtr mesh, Arguments&&... arguments)
      : Measured<Shape>(std::move(mesh), std::forward<Arguments>(arguments)...), curves(this->charts), march(curves) {}

  void run(const SurfacePoint& from) {
    source = from;
    flat.clear();
    for (Index v = 0; v < this->mesh->vertex_count(); ++v)
      flat.push_back(Measured<Shape>::flat.find(from, this->mesh->at_vertex(v)).first);
    march.run(flat, from, [this](const SurfacePoint& at) { return shortened(at); });
  }

  FrontPoint shortened(const SurfacePoint& at) {
    Path path = Measured<Shape>::flat.find(source, at).second;
    std::ranges::reverse(path);
    this->shorten(path);
    return front_at_end(curves, this->shortening, 0, this->mesh->vertex_at(at));
  }

  SmoothPoint above(const SurfacePoint& at) const {
    const auto [p, q, r] = this->mesh->corners(at.face);
    const SmoothPlace place{at, (q - p) / norm(q - p)};
    SmoothPoint point;
    this->charts.surface().evaluate({&place, 1}, {&point, 1});
    return point;
  }

  /// The mean and the largest relative error against paths, over vertices farther than `from`.
  std::pair<double, double> against_paths(double from) {
    double sum = 0, largest = 0;
    int count = 0;
    for (Index v = 0; v < flat.size(); ++v) {
      if (flat[v] < from) continue;
      const double path = shortened(this->mesh->at_vertex(v)).distance;
      const double error = std::abs(march.at_vertex(v).distance / path - 1);
      sum += error, largest = std::max(largest, error), ++count;
    }
    return {sum / count, largest};
  }

  EdgeCurves curves;
  FrontMarch march;
  SurfacePoint source;
  std::vector<double> flat;
};

double arc(const Vec3& p, const Vec3& q) { return std::atan2(norm(cross(p, q)), dot(p, q)); }

TEST(FrontMarch, HasTheArcsOfASphere) {
  Marched<Sphere> sphere(mesh_of(Sphere{}, 5120));
  sphere.run(sphere.mesh->at_vertex(17));
  const Vec3 from = sphere.mesh->positions()[17];
  for (Index v = 0; v < sphere.mesh->vertex_count(); ++v) {
    const Vec3 to = sphere.mesh->positions()[v];
    const FrontPoint& found = sphere.march.at_vertex(v);
    const double d = arc(from, to);
    ASSERT_NEAR(found.distance, d, 1e-6 * d) << v;
    if (d < 0.3 || d > 2.8) continue;
    const Vec3 gradient = (std::cos(d) * to - from) / std::sin(d);
    EXPECT_LT(norm(found.gradient - gradient), 1e-4) << v;
    EXPECT_NEAR(found.bend, d / std::tan(d), 1e-3 * (1 + d / std::sin(d))) << v;
  }
  EXPECT_LT(sphere.march.paths(), 20u) << "near the source and at its antipode";
}

TEST(FrontMarch, HasTheArcsOfPointsOfFaces) {
  Marched<Sphere> sphere(mesh_of(Sphere{}, 5120));
  const SurfacePoint from{100, {0.5, 0.3, 0.2}};
  sphere.run(from);
  for (Index face = 0; face < sphere.mesh->face_count(); face += 7) {
    const SurfacePoint to{face, {0.2, 0.3, 0.5}};
    const SmoothPoint above = sphere.above(to);
    const double d = arc(sphere.above(from).position, above.position);
    const double most = d < 2.9 ? 1e-6 : 1e-5;  // all ways are equally long to the antipode
    EXPECT_NEAR(sphere.march.at(to, above).distance, d, most * d) << face;
  }
}

TEST(FrontMarch, HasStraightLinesInAPlaneWithABorder) {
  Marched<Plane> plane(shaken(plane_grid(12, true), 0, 1));
  plane.run(plane.mesh->at_vertex(40));
  for (Index v = 0; v < plane.mesh->vertex_count(); ++v)
    EXPECT_NEAR(plane.march.at_vertex(v).distance, distance(plane.mesh->positions()[40], plane.mesh->positions()[v]),
                1e-9)
        << "steps of Newton's method end at 1e-5 of an edge, whose square counts";
}

template <class Shape>
void expect_the_lengths_of_paths(const Shape& shape) {
  Marched<Shape> coarse(mesh_of(shape, 1280), shape), fine(mesh_of(shape, 5120), shape);
  coarse.run(coarse.mesh->at_vertex(3)), fine.run(fine.mesh->at_vertex(3));
  EXPECT_LT(fine.against_paths(0.5).first, 1e-6);
  EXPECT_LT(coarse.against_paths(0.5).first, 1e-5);
  EXPECT_LT(fine.march.paths(), fine.mesh->vertex_count() / 20) << "all else was carried";
}

TEST(FrontMarch, HasTheLengthsOfPathsOfAnEllipsoid) { expect_the_lengths_of_paths(Ellipsoid{0.8, 0.6}); }

TEST(FrontMarch, HasTheLengthsOfPathsOfAStarShapedBody) { expect_the_lengths_of_paths(Star{}); }

TEST(FrontMarch, TakesTheNearerWayWhereThePathOnTheTrianglesIsTheLongerOne) {
  Marched<Torus> torus(mesh_of(Torus{}, 3000));
  torus.run(torus.mesh->at_vertex(11));
  int nearer = 0;
  for (Index v = 0; v < torus.flat.size(); ++v) {
    const double path = torus.shortened(torus.mesh->at_vertex(v)).distance, found = torus.march.at_vertex(v).distance;
    EXPECT_LE(found, path * (1 + 3e-5)) << v;
    nearer += found < path * (1 - 1e-4);
  }
  EXPECT_GE(nearer, 1);
}

TEST(FrontMarch, ShortensPathsOverFacesThatAreNotTrusted) {
  const MeshPtr mesh = mesh_of(Sphere{}, 1280);
  Marched<Sphere> sphere(mesh, Sphere{}, [&](Index face) {
    const auto [p, q, r] = mesh->corners(face);
    return std::abs(p.z + q.z + r.z) < 0.6 ? infinity : 0;
  });
  const Index top = static_cast<Index>(
      std::ranges::max_element(mesh->positions(), {}, [](const Vec3& p) { return p.z; }) - mesh->positions().begin());
  sphere.run(mesh->at_vertex(top));
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const FrontPoint path = sphere.shortened(mesh->at_vertex(v)), &found = sphere.march.at_vertex(v);
    if (mesh->positions()[v].z < 0) {
      EXPECT_EQ(found.distance, path.distance);
    }
    EXPECT_NEAR(found.distance, path.distance, 1e-5 * path.distance);
    EXPECT_NEAR(found.flat, path.flat, 1e-12);
  }
}

TEST(FrontMarch, LeavesOutWhatWasNotReached) {
  Marched<Sphere> sphere(mesh_of(Sphere{}, 1280));
  sphere.run(sphere.mesh->at_vertex(5));
  const double far = *std::ranges::max_element(sphere.flat), limit = far / 2;
  std::vector<double> near = sphere.flat;
  for (double& d : near)
    if (d > limit) d = infinity;
  FrontMarch march(sphere.curves);
  march.run(near, sphere.source, [&](const SurfacePoint& at) { return sphere.shortened(at); });
  for (Index v = 0; v < near.size(); ++v)
    EXPECT_EQ(march.at_vertex(v).distance, near[v] < infinity ? sphere.march.at_vertex(v).distance : infinity);
}

}  // namespace
}  // namespace geodrome::test
