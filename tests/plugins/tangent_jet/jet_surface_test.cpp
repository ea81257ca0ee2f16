// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/jet_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include "tests/plugins/tangent_jet/fitted_surface.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

using test::FittedSurface;

const FittedSurface& torus() {
  static const FittedSurface made = test::fitted("torus", {.points = 3000, .seed = 5});
  return made;
}

/// Places on random faces in random directions, up to a fifth of the face outside of it.
std::vector<SmoothPlace> random_places(const SurfaceMesh& mesh, std::size_t count) {
  test::Random random(9);
  std::vector<SmoothPlace> places;
  for (std::size_t i = 0; i < count; ++i) {
    const auto face = static_cast<Index>(random.below(mesh.face_count()));
    const double a = random.uniform(-0.2, 0.6), b = random.uniform(-0.2, 0.6);
    SmoothPlace place = test::place_on(mesh, face, {a, b, 1 - a - b});
    const auto [p, q, r] = mesh.corners(face);
    const Vec3 normal = cross(q - p, r - p) / norm(cross(q - p, r - p));
    const double turn = random.uniform(0, 2 * std::numbers::pi);
    place.direction = std::cos(turn) * place.direction + std::sin(turn) * cross(normal, place.direction);
    places.push_back(place);
  }
  return places;
}

/// The place moved in its plane.
SmoothPlace moved(const SurfaceMesh& mesh, SmoothPlace place, const Vec3& way) {
  const auto corners = mesh.corners(place.at.face);
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  for (int i = 0; i < 3; ++i)
    place.at.b[i] += dot(way, cross(normal, corners[(i + 2) % 3] - corners[(i + 1) % 3])) / squared_norm(normal);
  return place;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) { EXPECT_LT(distance(a, b), tolerance); }

TEST(JetSurface, DerivativesAreThoseOfPositionsAndNormals) {
  const SurfaceMesh& mesh = *torus().mesh;
  constexpr double step = 1e-5;
  for (const SmoothPlace& place : random_places(mesh, 300)) {
    const SmoothPoint at = torus().at(place);
    const SmoothPoint ahead = torus().at(moved(mesh, place, step * place.direction));
    const SmoothPoint behind = torus().at(moved(mesh, place, -step * place.direction));
    expect_near(at.velocity, (ahead.position - behind.position) / (2 * step), 1e-7);
    expect_near(at.acceleration, (ahead.velocity - behind.velocity) / (2 * step), 1e-5);
    expect_near(at.normal_velocity, (ahead.normal - behind.normal) / (2 * step), 1e-5);
  }
}

TEST(JetSurface, NormalIsAcrossEveryDirectionOnTheSideOfTheFace) {
  const SurfaceMesh& mesh = *torus().mesh;
  for (SmoothPlace place : random_places(mesh, 100)) {
    const auto [p, q, r] = mesh.corners(place.at.face);
    const Vec3 normal = torus().at(place).normal;
    EXPECT_NEAR(norm(normal), 1, 1e-14);
    EXPECT_GT(dot(normal, cross(q - p, r - p)), 0);
    EXPECT_NEAR(dot(normal, torus().at(place).velocity), 0, 1e-14);
    place.direction = (r - p) / norm(r - p);
    EXPECT_NEAR(dot(normal, torus().at(place).velocity), 0, 1e-14);
  }
}

TEST(JetSurface, PassesThroughTheVerticesOfACleanSample) {
  const SurfaceMesh& mesh = *torus().mesh;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (int i = 0; i < 3; ++i) {
      std::array<double, 3> b{};
      b[i] = 1;
      expect_near(torus().at(test::place_on(mesh, f, b)).position, mesh.positions()[mesh.triangles()[f][i]], 1e-15);
    }
}

TEST(JetSurface, IsContinuousAcrossEdgesAndItsNormalsNearlySo) {
  const SurfaceMesh& mesh = *torus().mesh;
  double worst = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index twin = mesh.twins()[h];
    std::array<double, 3> b{}, c{};
    b[h % 3] = 0.3, b[(h + 1) % 3] = 0.7;
    c[twin % 3] = 0.7, c[(twin + 1) % 3] = 0.3;
    const SmoothPoint here = torus().at(test::place_on(mesh, h / 3, b));
    const SmoothPoint there = torus().at(test::place_on(mesh, twin / 3, c));
    expect_near(here.position, there.position, 1e-14);
    worst = std::max(worst, distance(here.normal, there.normal));
  }
  EXPECT_LT(worst, 0.01);  // the faces are turned by up to half a right angle
}

TEST(JetSurface, ConvergesWithTheFifthPowerOfTheSpacingAndItsNormalsWithTheFourth) {
  for (const char* shape : {"torus", "ellipsoid"}) {
    const auto coarse = errors_of(test::fitted(shape, {.points = 2000}), shape);
    const auto fine = errors_of(test::fitted(shape, {.points = 8000}), shape);
    EXPECT_GT(test::quantile(coarse.position, 0.5) / test::quantile(fine.position, 0.5), 32) << shape;
    EXPECT_GT(test::quantile(coarse.normal, 0.5) / test::quantile(fine.normal, 0.5), 16) << shape;
  }
}

TEST(JetSurface, IsNearerThanTheFacesByThreeOrders) {
  for (const shapes::Sampling sampling : {shapes::Sampling::uniform, shapes::Sampling::blue, shapes::Sampling::grid}) {
    const FittedSurface made = test::fitted("torus", {.points = 8000, .sampling = sampling});
    const auto errors = errors_of(made, "torus");
    EXPECT_LT(test::quantile(errors.position, 0.5), 1e-3 * test::quantile(errors.flat, 0.5));
    EXPECT_LT(test::quantile(errors.position, 1), 1e-2 * test::quantile(errors.flat, 1));
  }
}

TEST(JetSurface, AveragesNoise) {
  for (const double noise : {0.001, 0.005}) {
    const auto errors = errors_of(test::fitted("torus", {.points = 8000, .noise = noise}), "torus");
    EXPECT_LT(test::quantile(errors.position, 0.5), 0.5 * test::quantile(errors.flat, 0.5));
  }
}

TEST(JetSurface, NoiseDoesNotShrinkIt) {
  // Offsets to one side make distances longer or shorter alike, and are not averaged along a path.
  const PointSample sample = shapes::sample("torus", {.points = 8000, .noise = 0.005});
  const FittedSurface made = test::fitted(sample, false);
  const SurfaceMesh& mesh = *made.mesh;
  double offset = 0, area = 0;
  for (Index f = 0; f < mesh.face_count(); f += 4) {
    const auto [p, q, r] = mesh.corners(f);
    const double part = norm(cross(q - p, r - p));
    const Vec3 at = made.at(test::place_on(mesh, f, test::middles[0])).position;
    offset += part * test::shape_value("torus", at), area += part;
  }
  EXPECT_LT(std::abs(offset / area), 0.05 * made.tangents.sigma);
}

TEST(JetSurface, AveragesNoiseThatTheEstimatorDoesNotNotice) {
  // A hundredth of the diagonal's thousandth: a fiftieth of the spacing.
  const FittedSurface noisy = test::fitted("trefoil", {.points = 8000, .noise = 1e-4});
  ASSERT_EQ(noisy.tangents.sigma, 0);
  const double sigma = 1e-4 * 3;  // the diagonal of the trefoil is 3.0
  EXPECT_LT(test::quantile(errors_of(noisy, "trefoil").position, 0.5), 0.9 * sigma);
}

TEST(JetSurface, MovesAndScalesWithTheSample) {
  for (const double noise : {0.0, 0.001}) {
    const FittedSurface made = test::fitted("ellipsoid", {.points = 2000, .noise = noise});
    for (const double scale : {1e-3, 1e3}) {
      const Vec3 offset = scale * Vec3{3, -2, 5};
      const auto there = [&](const Vec3& p) { return test::moved({{p}}, scale, offset).points[0]; };
      const MeshPtr mesh = test::mapped(made.mesh, there);
      const PointSample sample = test::moved(made.sample, scale, offset);
      Tangents tangents = made.tangents;
      for (TangentPlane& plane : tangents.plane)
        plane = {there(plane.origin), test::moved({{plane.normal}}, 1, {}).points[0], scale * plane.residual};
      tangents.sigma *= scale;
      const auto smooth = test::fitted_to(mesh, sample, tangents);
      for (Index f = 0; f < mesh->face_count(); ++f) {
        const double deviation = scale * made.smooth->deviation(f);
        ASSERT_EQ(smooth->deviation(f) < infinity, deviation < infinity);
        if (!(deviation < infinity)) continue;
        EXPECT_NEAR(smooth->deviation(f), deviation, 1e-9 * scale);
        const SmoothPlace place = test::place_on(*mesh, f, {0.2, 0.3, 0.5});
        SmoothPoint point;
        smooth->evaluate({&place, 1}, {&point, 1});
        expect_near(point.position, there(made.at(test::place_on(*made.mesh, f, {0.2, 0.3, 0.5})).position),
                    1e-10 * scale);
      }
    }
  }
}

TEST(JetSurface, DoesNotDependOnTheOrderOfThePoints) {
  const auto order = test::permutation(torus().sample.size(), 3);
  Tangents tangents = torus().tangents;
  for (std::size_t i = 0; i < order.size(); ++i) {
    tangents.plane[i] = torus().tangents.plane[order[i]];
    tangents.state[i] = torus().tangents.state[order[i]];
  }
  const auto smooth = test::fitted_to(torus().mesh, test::permuted(torus().sample, order), tangents);
  for (Index f = 0; f < torus().mesh->face_count(); ++f) {
    EXPECT_NEAR(smooth->deviation(f), torus().smooth->deviation(f), 1e-12);
    const SmoothPlace place = test::place_on(*torus().mesh, f, {0.2, 0.3, 0.5});
    SmoothPoint point;
    smooth->evaluate({&place, 1}, {&point, 1});
    expect_near(point.position, torus().at(place).position, 1e-13);
  }
}

TEST(JetSurface, HasTheSameBytesOnAnyNumberOfThreads) {
  const auto places = random_places(*torus().mesh, 1000);
  std::vector<SmoothPoint> one(places.size()), three(places.size());
  test::fitted_to(torus().mesh, torus().sample, torus().tangents, 1)->evaluate(places, one);
  test::fitted_to(torus().mesh, torus().sample, torus().tangents, 3)->evaluate(places, three);
  EXPECT_EQ(std::memcmp(one.data(), three.data(), one.size() * sizeof(SmoothPoint)), 0);
}

}  // namespace
}  // namespace geodrome
