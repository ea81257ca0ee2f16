// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/tangent_pole/pole_tangents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/recording_context.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/shape_equations.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

using shapes::Sampling;

using Context = test::RecordingContext;

/// Angle between two lines, in degrees.
double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))) * 180 / std::numbers::pi;
}

struct Errors {
  double mean = 0, largest = 0;
};

Errors errors_on(const std::string& kind, const PointSample& sample) {
  Context context;
  const Tangents tangents = PoleTangents().estimate(sample, context);
  Errors errors;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Vec3 gradient = test::shape_gradient(kind, sample.points[i]);
    const double error = angle(tangents.plane[i].normal, gradient / norm(gradient));
    errors.mean += error / static_cast<double>(sample.size());
    errors.largest = std::max(errors.largest, error);
  }
  return errors;
}

TEST(TangentPole, NormalsAreWithinDegrees) {
  EXPECT_LT(errors_on("torus", shapes::sample("torus", {8000, Sampling::uniform, 0, 1})).mean, 1.5);
  EXPECT_LT(errors_on("ellipsoid", shapes::sample("ellipsoid", {4000, Sampling::uniform, 0, 1})).mean, 1.5);
  EXPECT_LT(errors_on("genus2", shapes::sample("genus2", {4000, Sampling::blue, 0, 1})).mean, 5);
}

TEST(TangentPole, CocircularGridsTurnNoNormal) {
  const PointSample grid = shapes::sample("torus", {4000, Sampling::grid, 0, 1});
  EXPECT_LT(errors_on("torus", grid).largest, 20);
  EXPECT_LT(errors_on("torus", test::with_noise(grid, 1e-7, 3)).largest, 20);
}

TEST(TangentPole, APlaneHasNoPolesAndFallsBackCounted) {
  const PointSample flat = test::moved(test::plane_lattice(20, 30), 1, {1, 2, 3});
  const Vec3 axis = test::moved({{{0, 0, 1}}}, 1, {}).points[0];
  Context context;
  const Tangents tangents = PoleTangents().estimate(flat, context);
  for (const TangentPlane& plane : tangents.plane) ASSERT_LT(angle(plane.normal, axis), 1e-6);
  EXPECT_EQ(context.measures["fallback"], 600);
}

TEST(TangentPole, ACellWithoutEndHasTheMeanDirectionOfTheHull) {
  // The corners of a regular octahedron and its centre.
  const PointSample sample{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0.01, 0.02, 0.03}}};
  Context context;
  const Tangents tangents = PoleTangents().estimate(sample, context);
  EXPECT_EQ(context.measures["unbounded"], 6);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_LT(angle(tangents.plane[i].normal, sample.points[i]), 1e-6);
}

TEST(TangentPole, DoesNotDependOnTheOrderOfPoints) {
  for (const Sampling sampling : {Sampling::uniform, Sampling::grid}) {
    const PointSample sample = shapes::sample("torus", {3000, sampling, 0, 1});
    const std::vector<Index> order = test::permutation(sample.size(), 3);
    Context context;
    const Tangents one = PoleTangents().estimate(sample, context),
                   other = PoleTangents().estimate(test::permuted(sample, order), context);
    for (std::size_t i = 0; i < order.size(); ++i)
      ASSERT_LT(angle(other.plane[i].normal, one.plane[order[i]].normal), 1e-6) << i;
  }
}

TEST(TangentPole, TurnsAndScalesWithTheSample) {
  const PointSample sample = shapes::sample("trefoil", {3000, Sampling::uniform, 0, 1});
  Context context;
  const Tangents one = PoleTangents().estimate(sample, context);
  PointSample normals;
  for (const TangentPlane& plane : one.plane) normals.points.push_back(plane.normal);
  normals = test::moved(normals, 1, {});
  for (const double scale : {1e-6, 1e6}) {
    const Tangents other = PoleTangents().estimate(test::moved(sample, scale, scale * Vec3{1, -2, 3}), context);
    for (std::size_t i = 0; i < sample.size(); ++i)
      ASSERT_LT(angle(other.plane[i].normal, normals.points[i]), 1e-6) << i;
  }
}

TEST(TangentPole, PointsOnALineAreRefused) {
  PointSample line;
  for (int i = 0; i < 50; ++i) line.points.push_back({0.1 * i, 0.2 * i, -0.3 * i});
  Context context;
  EXPECT_THROW(PoleTangents().estimate(line, context), SampleError);
}

}  // namespace
}  // namespace geodrome
