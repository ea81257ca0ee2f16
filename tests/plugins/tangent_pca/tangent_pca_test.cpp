// SPDX-License-Identifier: MIT
#include "plugins/tangent_pca/pca_tangents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "tests/support/samples.hpp"
#include "tests/support/threads_context.hpp"

namespace geodrome {
namespace {

Tangents tangents_of(const PointSample& sample, const char* options = "") {
  test::ThreadsContext context(2);
  return PcaTangents(OptionValues(pca_options, options)).estimate(sample, context);
}

/// Angle between two lines, in degrees.
double angle(const Vec3& a, const Vec3& b) {
  return std::asin(std::min(1.0, norm(cross(a, b)))) * 180 / std::numbers::pi;
}

TEST(TangentPca, NormalsOfAPlaneAreExact) {
  for (const PointSample& flat : {test::plane(500, 1), test::plane_lattice(20, 30)}) {
    const Vec3 axis = test::moved({{{0, 0, 1}}}, 1, {}).points[0];
    const Tangents tangents = tangents_of(test::moved(flat, 1, {}));
    for (const TangentPlane& plane : tangents.plane) ASSERT_LT(angle(plane.normal, axis), 1e-6);
  }
}

TEST(TangentPca, NormalsOfATorusAreWithinDegrees) {
  const PointSample sample = test::torus(20000, 2);
  const Tangents tangents = tangents_of(sample);
  double sum = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Vec3& p = sample.points[i];
    const double ring = std::hypot(p.x, p.y);
    const Vec3 normal = Vec3{p.x - p.x / ring, p.y - p.y / ring, p.z} / 0.4;
    sum += angle(tangents.plane[i].normal, normal);
  }
  EXPECT_LT(sum / static_cast<double>(sample.size()), 1);
}

TEST(TangentPca, ResidualIsTheRootMeanSquareDistanceFromThePlane) {
  // Heights 0.1 and -0.1 in turn on a fine lattice: the least-squares plane is z = 0 but for the odd point.
  PointSample sample = test::plane_lattice(40, 40);
  for (std::size_t i = 0; i < sample.size(); ++i) sample.points[i].z = (i % 40 + i / 40) % 2 ? 0.1 : -0.1;
  const Tangents tangents = tangents_of(sample, "k=400");
  EXPECT_NEAR(tangents.plane[20 * 40 + 20].residual, 0.1, 1e-3);
}

TEST(TangentPca, ResidualOfAnExactPlaneIsRounding) {
  const Tangents tangents = tangents_of(test::moved(test::plane(500, 3), 1, {}));
  for (const TangentPlane& plane : tangents.plane) ASSERT_LT(plane.residual, 1e-15);
}

TEST(TangentPca, RowsOfAScanStillShowTheirPlane) {
  // Spacing 1 : 100: the 30 nearest points of any point are in its own row.
  PointSample sample = test::plane_lattice(2000, 5);
  for (Vec3& p : sample.points) p.x *= 0.01;
  const Vec3 axis = test::moved({{{0, 0, 1}}}, 1, {}).points[0];
  const Tangents tangents = tangents_of(test::moved(sample, 1, {}));
  for (const TangentPlane& plane : tangents.plane) ASSERT_LT(angle(plane.normal, axis), 1e-6);
}

TEST(TangentPca, RowsLongerThanFourHundredPointsStillShowTheirPlane) {
  PointSample sample = test::plane_lattice(1500, 2);
  for (Vec3& p : sample.points) p.y *= 5000;
  const Tangents tangents = tangents_of(sample);
  for (const TangentPlane& plane : tangents.plane) ASSERT_LT(angle(plane.normal, {0, 0, 1}), 1e-6);
}

TEST(TangentPca, UsesWhatThereIsWhenPointsAreFewerThanK) {
  const Tangents tangents = tangents_of({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}});
  for (const TangentPlane& plane : tangents.plane) EXPECT_LT(angle(plane.normal, {0, 0, 1}), 1e-12);
}

TEST(TangentPca, OriginIsThePointItself) {
  const PointSample sample = test::with_noise(test::torus(300, 1), 0.1, 2);
  const Tangents tangents = tangents_of(sample);
  for (std::size_t i = 0; i < sample.size(); ++i) ASSERT_EQ(tangents.plane[i].origin, sample.points[i]);
}

void expect_refused(const PointSample& sample) {
  try {
    tangents_of(sample);
    FAIL() << "not refused";
  } catch (const SampleError& error) {
    EXPECT_TRUE(std::regex_search(error.what(), std::regex("^point [0-9]+ has no tangent plane"))) << error.what();
  }
}

TEST(TangentPca, FewerThanThreePointsAreRefused) {
  expect_refused({});
  expect_refused({{{0, 0, 0}}});
  expect_refused({{{0, 0, 0}, {1, 2, 3}}});
}

TEST(TangentPca, PointsOnALineAreRefused) {
  test::Random random(1);
  for (const Vec3& offset : {Vec3{}, Vec3{1e6, -1e6, 1e6}}) {
    PointSample sample;
    const Vec3 direction = random.direction();
    for (int i = 0; i < 1000; ++i) sample.points.push_back(offset + random.uniform(-1, 1) * direction);
    expect_refused(sample);
  }
}

TEST(TangentPca, TheNeighbourhoodDoesNotDependOnTheOrderOfPoints) {
  for (const PointSample& sample : {test::with_noise(test::torus(1000, 1), 0.05, 2), test::plane_lattice(20, 20)}) {
    const std::vector<Index> order = test::permutation(sample.size(), 3);
    const Tangents one = tangents_of(sample), other = tangents_of(test::permuted(sample, order));
    for (std::size_t i = 0; i < order.size(); ++i)
      ASSERT_LT(angle(other.plane[i].normal, one.plane[order[i]].normal), 1e-9);
  }
}

}  // namespace
}  // namespace geodrome
