// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "geodrome/engine/input.hpp"
#include "plugins/tangent_jet/smooth/trust.hpp"
#include "tests/plugins/tangent_jet/fitted_surface.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

using test::FittedSurface;

double share_within(const test::ShapeErrors& errors, double factor) {
  std::size_t within = 0;
  for (std::size_t i = 0; i < errors.position.size(); ++i) within += errors.position[i] <= factor * errors.deviation[i];
  return static_cast<double>(within) / static_cast<double>(errors.position.size());
}

double trusted_share(const FittedSurface& surface) {
  std::size_t trusted = 0;
  for (Index f = 0; f < surface.mesh->face_count(); ++f) trusted += surface.trusted(f);
  return static_cast<double>(trusted) / static_cast<double>(surface.mesh->face_count());
}

/// Uniform on a box from the origin.
PointSample box(const Vec3& sides, std::size_t count, double noise) {
  test::Random random(3);
  const double xy = sides.x * sides.y, yz = sides.y * sides.z, zx = sides.z * sides.x;
  PointSample sample;
  while (sample.size() < count) {
    const double which = random.uniform(0, xy + yz + zx), side = random.below(2) == 0 ? 0 : 1;
    const double a = random.uniform(), b = random.uniform(), off = side + random.uniform(-noise, noise);
    const Vec3 p = which < xy ? Vec3{a, b, off} : which < xy + yz ? Vec3{off, a, b} : Vec3{a, off, b};
    sample.points.push_back({p.x * sides.x, p.y * sides.y, p.z * sides.z});
  }
  return sample;
}

/// Whether the corners of a face are not all on one side of the box.
bool over_an_edge(const std::array<Vec3, 3>& corners, const Vec3& sides) {
  const auto all_at = [&](double Vec3::*coordinate, double value) {
    return std::ranges::all_of(corners, [&](const Vec3& c) { return c.*coordinate == value; });
  };
  for (double Vec3::*coordinate : {&Vec3::x, &Vec3::y, &Vec3::z})
    if (all_at(coordinate, 0) || all_at(coordinate, sides.*coordinate)) return false;
  return true;
}

TEST(SmoothTrust, DeviationTellsHowFarTheSmoothSurfaceIs) {
  for (const char* shape : {"torus", "ellipsoid", "trefoil", "genus2", "cut-torus"}) {
    const auto errors = errors_of(test::fitted(shape, {.points = 8000, .seed = 2}), shape);
    EXPECT_GT(share_within(errors, 1), 0.8) << shape;
    EXPECT_GT(share_within(errors, 4), 0.98) << shape;
    EXPECT_LT(share_within(errors, 0.1), 0.2) << shape << ": too careful";
  }
}

TEST(SmoothTrust, DeviationTellsWhatIsLeftOfNoise) {
  for (const double noise : {0.001, 0.005, 0.01}) {
    const auto errors = errors_of(test::fitted("ellipsoid", {.points = 8000, .noise = noise}), "ellipsoid");
    EXPECT_GT(share_within(errors, 1), 0.7) << noise;
    EXPECT_GT(share_within(errors, 3), 0.98) << noise;
    EXPECT_LT(share_within(errors, 0.1), 0.2) << noise << ": too careful";
  }
}

TEST(SmoothTrust, DeviationHoldsWhereDenseAndSparsePointsMeet) {
  // The density falls to a 900th, and decimation leaves edges that differ by as much as their square root.
  const FittedSurface made = test::fitted(test::torus(8000, 300, 30));
  const auto errors = errors_of(made, "torus");
  EXPECT_GT(share_within(errors, 1), 0.7);
  EXPECT_GT(share_within(errors, 4), 0.95);
  EXPECT_GT(trusted_share(made), 0.7);
  EXPECT_LT(test::quantile(errors.position, 0.5), 0.05 * test::quantile(errors.flat, 0.5));
}

TEST(SmoothTrust, WholeSmoothShapesAreTrusted) {
  for (const char* shape : {"torus", "ellipsoid", "sphere", "trefoil", "cut-sphere", "cut-torus", "swiss-roll"})
    EXPECT_EQ(trusted_share(test::fitted(shape, {.points = 8000})), 1) << shape;
  EXPECT_GT(trusted_share(test::fitted("ellipsoid", {.points = 8000, .noise = 0.005})), 0.99);
}

TEST(SmoothTrust, WhatIsTrustedIsNearerThanTheFace) {
  for (const char* shape : {"torus", "ellipsoid", "trefoil", "genus2", "genus5", "cut-torus"})
    for (const std::size_t points : {2000, 8000}) {
      const auto errors = errors_of(test::fitted(shape, {.points = points, .seed = 4}), shape);
      std::size_t worse = 0;
      for (std::size_t i = 0; i < errors.position.size(); ++i) worse += errors.position[i] > errors.flat[i];
      EXPECT_LE(worse, errors.position.size() / 500) << shape << " " << points;
    }
}

TEST(SmoothTrust, NoFaceOverAnEdgeOfABoxIsTrusted) {
  for (const Vec3& sides : {Vec3{1, 1, 1}, Vec3{1, 1, 0.1}})
    for (const std::size_t points : {2000, 8000}) {
      const FittedSurface made = test::fitted(box(sides, points, 0));
      std::size_t over = 0, far = 0;
      for (Index f = 0; f < made.mesh->face_count(); ++f) {
        const auto corners = made.mesh->corners(f);
        over += over_an_edge(corners, sides);
        if (!made.trusted(f)) continue;
        EXPECT_FALSE(over_an_edge(corners, sides));
        const Vec3 flat = made.mesh->position({f, test::middles[0]});
        far += distance(made.at(test::place_on(*made.mesh, f, test::middles[0])).position, flat) >
               0.02 * distance(corners[0], corners[1]);
      }
      EXPECT_GT(over, 0u);
      EXPECT_EQ(far, 0u) << "sides are flat";
    }
}

TEST(SmoothTrust, HardlyAFaceAtACreaseWithPointsOnItIsTrusted) {
  for (const double degrees : {30, 45}) {
    const double turned = degrees / 2 * std::numbers::pi / 180;
    test::Random random(6);
    PointSample sample;
    const auto add = [&](double u, double y) {
      sample.points.push_back({u * std::cos(turned), y, -std::abs(u) * std::sin(turned)});
    };
    for (int i = 0; i < 3000; ++i) {
      const double u = random.uniform(-1, 1);
      add(u, random.uniform(0, 2));
    }
    for (int i = 0; i <= 60; ++i) add(0, i / 30.0);
    const FittedSurface made = test::fitted(sample);
    std::size_t at_crease = 0, trusted = 0;
    for (Index f = 0; f < made.mesh->face_count(); ++f)
      if (std::ranges::any_of(made.mesh->corners(f), [](const Vec3& p) { return p.x == 0; }))
        ++at_crease, trusted += made.trusted(f);
    EXPECT_GT(at_crease, 50u);
    EXPECT_LT(trusted, at_crease / 20) << degrees << " " << at_crease;
  }
}

TEST(SmoothTrust, FacesInTheMiddleOfTheSidesOfACubeAreTrusted) {
  EXPECT_GT(trusted_share(test::fitted(box({1, 1, 1}, 8000, 0))), 0.4);
}

TEST(SmoothTrust, NoFaceAtASharpEdgeOfAMachinePartIsTrusted) {
  const auto file = std::filesystem::path(GEODROME_SHARED_DATA) / "meshes" / "fandisk.off";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const FittedSurface made = test::fitted({read_input(file, {}).positions});
  const SurfaceMesh& mesh = *made.mesh;
  const auto normal = [&](Index f) {
    const auto [p, q, r] = mesh.corners(f);
    return cross(q - p, r - p) / norm(cross(q - p, r - p));
  };
  std::size_t sharp = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index twin = mesh.twins()[h];
    if (twin == no_index || dot(normal(h / 3), normal(twin / 3)) > std::cos(0.5)) continue;
    ++sharp;
    EXPECT_FALSE(made.trusted(h / 3)) << h;
  }
  EXPECT_GT(sharp, 200u);
}

TEST(SmoothTrust, NothingIsTrustedWhereThereAreTooFewPoints) {
  for (const std::size_t points : {0, 1, 10, 23}) {
    const PointSample sample = test::plane(points, 1);
    Tangents tangents;
    for (const Vec3& p : sample.points) tangents.plane.push_back({p, {0, 0, 1}, 0});
    tangents.state.assign(points, PointState::ok);
    const auto smooth = test::fitted_to(test::plane_grid(2), sample, tangents);
    for (Index f = 0; f < 8; ++f) EXPECT_EQ(smooth->deviation(f), infinity);
  }
}

TEST(SmoothTrust, FacesBeyondTheSampleAreNotTrustedOrTheirDeviationSaysSo) {
  // A cap of the sample is dropped; the mesh still covers it.
  FittedSurface made = test::fitted("trefoil", {.points = 4000});
  const auto gone = [](const Vec3& p) { return p.x > 0.5 && p.y > 0; };
  for (std::size_t i = 0; i < made.sample.size(); ++i)
    if (gone(made.sample.points[i])) made.tangents.state[i] = PointState::dropped;
  made.smooth = test::fitted_to(made.mesh, made.sample, made.tangents);
  EXPECT_GT(share_within(errors_of(made, "trefoil"), 4), 0.97);
  for (Index f = 0; f < made.mesh->face_count(); ++f) {
    const bool deep = std::ranges::all_of(made.mesh->corners(f), [](const Vec3& p) { return p.x > 0.8 && p.y > 0.3; });
    EXPECT_FALSE(deep && made.trusted(f)) << f;
  }
}

}  // namespace
}  // namespace geodrome
