// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "tests/support/shape_equations.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

using shapes::Sampling;

std::tuple<double, double, double> key(const Vec3& p) { return {p.x, p.y, p.z}; }

double least_distance(const PointSample& sample) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sample.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, squared_distance(sample.points[i], sample.points[j]));
  return std::sqrt(least);
}

/// The shares of the mass whose heights fall into equal slabs between `low` and `high`.
std::vector<double> slab_shares(const std::vector<std::pair<double, double>>& height_and_mass, double low, double high,
                                std::size_t slabs) {
  std::vector<double> share(slabs, 0.0);
  double total = 0;
  for (const auto& [height, mass] : height_and_mass) {
    const double slot = std::clamp((height - low) / (high - low), 0.0, 1.0) * static_cast<double>(slabs);
    share[std::min(slabs - 1, static_cast<std::size_t>(slot))] += mass;
    total += mass;
  }
  for (double& s : share) s /= total;
  return share;
}

/// Pearson's chi-square of the points' counts in slabs against a fine mesh's areas, and its degrees of freedom.
std::pair<double, double> chi_square(const PointSample& sample, const SurfaceMesh& mesh, const Vec3& direction) {
  constexpr std::size_t slabs = 25;
  std::vector<std::pair<double, double>> areas, points;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    areas.emplace_back(dot(direction, p + q + r) / 3, norm(cross(q - p, r - p)));
  }
  for (const Vec3& p : sample.points) points.emplace_back(dot(direction, p), 1);
  const auto [low, high] = std::minmax_element(areas.begin(), areas.end());
  const auto expected = slab_shares(areas, low->first, high->first, slabs);
  const auto seen = slab_shares(points, low->first, high->first, slabs);
  double sum = 0, used = 0;
  for (std::size_t i = 0; i < slabs; ++i) {
    if (expected[i] * static_cast<double>(sample.size()) < 5) continue;  // too few for the approximation
    sum += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
    ++used;
  }
  return {sum * static_cast<double>(sample.size()), used - 1};
}

class ShapeSample : public testing::TestWithParam<std::string> {
 protected:
  const std::string& kind() const { return GetParam(); }
};

TEST_P(ShapeSample, LiesOnTheShape) {
  for (const Sampling sampling : {Sampling::uniform, Sampling::blue, Sampling::grid})
    for (const Vec3& p : shapes::sample(kind(), {.points = 1500, .sampling = sampling, .seed = 5}).points) {
      ASSERT_LE(test::distance_off_shape(kind(), p), 1e-12) << static_cast<int>(sampling);
      ASSERT_TRUE(test::within_borders(kind(), p)) << static_cast<int>(sampling);
    }
}

TEST_P(ShapeSample, HasExactlyAsManyPointsAsAsked) {
  for (const std::size_t points : {4, 500, 1001})
    for (const Sampling sampling : {Sampling::uniform, Sampling::blue})
      EXPECT_EQ(shapes::sample(kind(), {.points = points, .sampling = sampling}).size(), points);
}

TEST_P(ShapeSample, LatticeHasAboutAsManyPointsAsAsked) {
  for (const std::size_t points : {2000, 5000}) {
    const double count =
        static_cast<double>(shapes::sample(kind(), {.points = points, .sampling = Sampling::grid}).size());
    EXPECT_NEAR(count / static_cast<double>(points), 1, 0.15);
  }
}

TEST_P(ShapeSample, HasNoPointTwice) {
  for (const Sampling sampling : {Sampling::uniform, Sampling::blue, Sampling::grid}) {
    const PointSample sample = shapes::sample(kind(), {.points = 3000, .sampling = sampling, .seed = 9});
    std::set<std::tuple<double, double, double>> different;
    for (const Vec3& p : sample.points) different.insert(key(p));
    EXPECT_EQ(different.size(), sample.size()) << static_cast<int>(sampling);
  }
}

TEST_P(ShapeSample, IsTheSameForTheSameArguments) {
  for (const Sampling sampling : {Sampling::uniform, Sampling::blue, Sampling::grid}) {
    const shapes::SampleSpec spec{.points = 800, .sampling = sampling, .noise = 0.01, .seed = 11};
    EXPECT_TRUE(shapes::sample(kind(), spec).points == shapes::sample(kind(), spec).points);
  }
}

TEST_P(ShapeSample, DependsOnTheSeed) {
  for (const Sampling sampling : {Sampling::uniform, Sampling::blue})
    EXPECT_FALSE(shapes::sample(kind(), {.points = 100, .sampling = sampling, .seed = 1}).points ==
                 shapes::sample(kind(), {.points = 100, .sampling = sampling, .seed = 2}).points);
}

TEST_P(ShapeSample, UniformOnesAreUniformByArea) {
  const PointSample sample = shapes::sample(kind(), {.points = 20000, .seed = 3});
  const SurfaceMesh mesh = shapes::mesh(kind(), 150000);
  // The plane's own normal would put all in one slab, so no direction is an axis.
  for (const Vec3& direction : {Vec3{0.93, 0.21, 0.3}, Vec3{-0.37, 0.88, 0.29}, Vec3{0.25, 0.31, 0.92}}) {
    const auto [statistic, freedom] = chi_square(sample, mesh, direction);
    EXPECT_LT(statistic, freedom + 4 * std::sqrt(2 * freedom));  // mean plus four standard deviations
  }
}

TEST_P(ShapeSample, BlueNoiseKeepsItsDistance) {
  const double blue = least_distance(shapes::sample(kind(), {.points = 2000, .sampling = Sampling::blue}));
  const double uniform = least_distance(shapes::sample(kind(), {.points = 2000}));
  EXPECT_GT(blue, 8 * uniform);
}

TEST_P(ShapeSample, NoiseGoesAlongTheNormalWithItsDeviation) {
  const PointSample exact = shapes::sample(kind(), {.points = 4000, .sampling = Sampling::grid});
  const PointSample noisy = shapes::sample(kind(), {.points = 4000, .sampling = Sampling::grid, .noise = 0.002});
  Vec3 low = exact.points[0], high = low;
  double squares = 0, worst_sine = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Vec3 &p = exact.points[i], move = noisy.points[i] - p, normal = test::shape_gradient(kind(), p);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    squares += squared_norm(move);
    worst_sine = std::max(worst_sine, norm(cross(move, normal)) / norm(normal));
  }
  const double deviation = std::sqrt(squares / static_cast<double>(exact.size()));
  EXPECT_NEAR(deviation / (0.002 * distance(low, high)), 1,
              0.045);                       // 4000 numbers: four times its own deviation of 1.1 %
  EXPECT_LT(worst_sine, 1e-6 * deviation);  // what central differences can tell of the normal
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ShapeSample, testing::ValuesIn(shapes::sample_kinds()), test_name);

TEST(ShapeSamples, RefuseWhatTheyCannotDo) {
  EXPECT_THROW(shapes::sample("icosphere", {}), OptionError);
  EXPECT_THROW(shapes::sample("torus", {.points = 3}), OptionError);
  EXPECT_THROW(shapes::sample("torus", {.noise = -1}), OptionError);
  EXPECT_THROW(shapes::sample("torus", {.noise = NAN}), OptionError);
}

TEST(ShapeSamples, PlaneLatticeIsASquareGridWithItsBorder) {
  const PointSample sample = shapes::sample("plane", {.points = 121, .sampling = Sampling::grid});
  ASSERT_EQ(sample.size(), 121U);
  for (const Vec3& p : sample.points) {
    ASSERT_NEAR(p.x * 10, std::round(p.x * 10), 1e-12);
    ASSERT_NEAR(p.y * 10, std::round(p.y * 10), 1e-12);
  }
}

TEST(ShapeSamples, BlueNoiseOnThePlaneComesNearTheHexagonalPacking) {
  constexpr std::size_t points = 2000;
  const double hexagonal = std::sqrt(2 / (std::numbers::sqrt3 * points));
  EXPECT_GT(least_distance(shapes::sample("plane", {.points = points, .sampling = Sampling::blue})), 0.6 * hexagonal);
}

}  // namespace
}  // namespace geodrome
