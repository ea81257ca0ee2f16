// SPDX-License-Identifier: MIT
#include "plugins/common/points/boundary_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/sample_stages.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/threads_context.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

std::vector<double> spacing_of(const test::Staged& s) {
  QuietContext context;
  return boundary_spacing(s.sample, s.control, context, {});
}

TEST(BoundarySpacing, FindsNoneOnClosedSurfaces) {
  for (const char* shape : {"sphere", "ellipsoid", "torus", "genus2", "genus5", "trefoil"})
    for (const shapes::Sampling sampling : {shapes::Sampling::uniform, shapes::Sampling::blue, shapes::Sampling::grid})
      for (const double noise : {0.0, 0.005}) {
        const auto spacing =
            spacing_of(test::staged(shapes::sample(shape, {.points = 4000, .sampling = sampling, .noise = noise})));
        EXPECT_EQ(std::ranges::count_if(spacing, [](double s) { return s > 0; }), 0) << shape << " " << noise;
      }
}

/// `at_rim` tells how far a point is from the rim.
template <class Distance>
void expect_only_the_rim(const test::Staged& s, double step, std::size_t least, Distance at_rim) {
  const std::vector<double> spacing = spacing_of(s);
  std::size_t found = 0;
  for (std::size_t i = 0; i < spacing.size(); ++i) {
    if (!(spacing[i] > 0)) continue;
    ++found;
    EXPECT_LT(at_rim(s.sample.points[i]), 4 * step) << i;
    EXPECT_GT(spacing[i], 0.5 * step) << i;
    EXPECT_LT(spacing[i], 1.4 * step) << i;
  }
  EXPECT_GE(found, least);
}

TEST(BoundarySpacing, FindsTheCutOfASphereAndNothingElse) {
  const test::Staged s = test::staged(shapes::sample("cut-sphere", {.points = 4000, .seed = 2}));
  const double step = std::sqrt(3 * std::numbers::pi / 4000);  // a cap of height 3/2
  expect_only_the_rim(s, step, static_cast<std::size_t>(0.5 * 2 * std::numbers::pi * std::sqrt(0.75) / step),
                      [](const Vec3& p) { return 0.5 - p.z; });
}

TEST(BoundarySpacing, FindsASlitOfFourSpacingsAcrossASphereThatHasNoOtherRim) {
  const double step = std::sqrt(4 * std::numbers::pi / 8000), half = 2 * step;
  PointSample sphere = test::sphere(8000, 3);
  const auto in_slit = [&](const Vec3& p) { return p.x > 0 && std::abs(p.y) < half && std::abs(p.z) < 0.7; };
  std::erase_if(sphere.points, in_slit);
  expect_only_the_rim(test::staged(sphere), step, 40, [&](const Vec3& p) {
    return std::max({0.0, std::abs(p.y) - half, std::abs(p.z) - 0.7});
  });
}

TEST(BoundarySpacing, IsTheSameForAnyNumberOfThreads) {
  const test::Staged s = test::staged(shapes::sample("s-curve", {.points = 2000}));
  test::ThreadsContext one(1), three(3);
  EXPECT_EQ(boundary_spacing(s.sample, s.control, one, {}), boundary_spacing(s.sample, s.control, three, {}));
}

}  // namespace
}  // namespace geodrome
