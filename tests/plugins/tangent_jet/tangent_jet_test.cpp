// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/jet_tangents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include "plugins/tangent_jet/smoothing.hpp"
#include "tests/support/recording_context.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/shape_equations.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

using shapes::Sampling;

using Context = test::RecordingContext;

Tangents tangents_of(const PointSample& sample, const char* options = "") {
  Context context;
  return JetTangents(OptionValues(jet_options, options)).estimate(sample, context);
}

PointSample shape(const std::string& kind, std::size_t points, Sampling sampling = Sampling::uniform, double noise = 0,
                  std::uint64_t seed = 1) {
  return shapes::sample(kind, {points, sampling, noise, seed});
}

/// Angle between two lines, in degrees.
double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))) * 180 / std::numbers::pi;
}

/// The shapes' equations are slow: every so many points are looked at.
std::size_t stride(const Tangents& tangents) { return tangents.plane.size() / 1000 + 1; }

/// Mean angle between the normals and those of the shape at the origins.
double mean_error(const std::string& kind, const Tangents& tangents) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < tangents.plane.size(); i += stride(tangents), ++count) {
    const Vec3 gradient = test::shape_gradient(kind, tangents.plane[i].origin);
    sum += angle(tangents.plane[i].normal, gradient / norm(gradient));
  }
  return sum / count;
}

double root_mean_square_distance(const std::string& kind, const Tangents& tangents) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < tangents.plane.size(); i += stride(tangents), ++count)
    sum += std::pow(test::distance_off_shape(kind, tangents.plane[i].origin), 2);
  return std::sqrt(sum / count);
}

Vec3 extent(const PointSample& sample) {
  Vec3 low = sample.points[0], high = low;
  for (const Vec3& p : sample.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return high - low;
}

std::size_t dropped(const Tangents& tangents, std::size_t begin, std::size_t end) {
  return static_cast<std::size_t>(
      std::count(tangents.state.begin() + begin, tangents.state.begin() + end, PointState::dropped));
}

// ---- normals

TEST(TangentJet, NormalsOfATorusAreWithinThreeHundredthsOfADegree) {
  for (const Sampling sampling : {Sampling::uniform, Sampling::grid})
    EXPECT_LT(mean_error("torus", tangents_of(shape("torus", 20000, sampling))), 0.03);
}

TEST(TangentJet, NormalsOfOtherShapesAreRight) {
  EXPECT_LT(mean_error("ellipsoid", tangents_of(shape("ellipsoid", 4000))), 0.15);
  EXPECT_LT(mean_error("ellipsoid", tangents_of(shape("ellipsoid", 4000, Sampling::grid))), 0.15);
  EXPECT_LT(mean_error("trefoil", tangents_of(shape("trefoil", 4000))), 1);
  EXPECT_LT(mean_error("genus2", tangents_of(shape("genus2", 4000, Sampling::blue))), 1);
}

TEST(TangentJet, NormalsConvergeWithTheSpacingSquared) {
  const double coarse = mean_error("torus", tangents_of(shape("torus", 2000)));
  const double fine = mean_error("torus", tangents_of(shape("torus", 32000)));
  EXPECT_GT(coarse / fine, 12);  // the spacing falls to a quarter
}

TEST(TangentJet, NormalsOfAPlaneAreExact) {
  const Vec3 axis = test::moved({{{0, 0, 1}}}, 1, {}).points[0];
  for (const PointSample& flat : {test::plane(500, 1), test::plane_lattice(20, 30)}) {
    const Tangents tangents = tangents_of(test::moved(flat, 1, {}));
    EXPECT_EQ(tangents.sigma, 0);
    EXPECT_EQ(dropped(tangents, 0, flat.size()), 0U);
    for (const TangentPlane& plane : tangents.plane) ASSERT_LT(angle(plane.normal, axis), 1e-6);
  }
}

TEST(TangentJet, JitterFarBelowTheSpacingDoesNotTurnTheNormalsOfALattice) {
  for (const char* kind : {"torus", "ellipsoid", "plane"}) {
    const PointSample exact = shape(kind, 3000, Sampling::grid), jittered = test::with_noise(exact, 1e-7, 3);
    const Tangents a = tangents_of(exact), b = tangents_of(jittered);
    EXPECT_EQ(b.sigma, 0);
    double sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) sum += angle(a.plane[i].normal, b.plane[i].normal);
    // Ties at the last place differ, so some neighbourhoods do: no more than the error itself.
    EXPECT_LT(sum / static_cast<double>(exact.size()), 0.15) << kind;
  }
}

TEST(TangentJet, RowsOfAScanStillShowTheirPlane) {
  // Spacing 1 : 100: the 20 nearest points of any point are in its row.
  PointSample sample = test::plane_lattice(2000, 5);
  for (Vec3& p : sample.points) p.x *= 0.01;
  const Vec3 axis = test::moved({{{0, 0, 1}}}, 1, {}).points[0];
  Context context;
  const Tangents tangents = JetTangents(OptionValues(jet_options)).estimate(test::moved(sample, 1, {}), context);
  for (const TangentPlane& plane : tangents.plane) ASSERT_LT(angle(plane.normal, axis), 1e-6);
  EXPECT_EQ(context.measures["grown_neighbourhoods"], 10000);
}

TEST(TangentJet, UsesWhatThereIsWhenPointsAreFew) {
  for (const std::size_t n : {3U, 5U, 8U, 20U}) {
    const Tangents tangents = tangents_of(test::moved(test::plane(n, 3), 1, {}));
    const Vec3 axis = test::moved({{{0, 0, 1}}}, 1, {}).points[0];
    for (const TangentPlane& plane : tangents.plane) EXPECT_LT(angle(plane.normal, axis), 1e-6) << n;
  }
}

TEST(TangentJet, PointsOnALineAreRefusedByName) {
  PointSample line;
  for (int i = 0; i < 100; ++i) line.points.push_back({0.1 * i, 0.2 * i, -0.3 * i});
  for (const PointSample& sample : {PointSample{}, PointSample{{{0, 0, 0}, {1, 2, 3}}}, line}) try {
      tangents_of(sample);
      FAIL() << sample.size();
    } catch (const SampleError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("point ")) << error.what();
    }
}

// ---- noise

TEST(TangentJet, CleanSamplesAreNotSmoothed) {
  for (const char* kind : {"torus", "ellipsoid", "trefoil", "genus2", "genus5", "plane"})
    for (const Sampling sampling : {Sampling::uniform, Sampling::blue, Sampling::grid})
      for (const std::size_t n : {600U, 1500U}) {
        const PointSample sample = shape(kind, n, sampling);
        const Tangents tangents = tangents_of(sample, "outliers=off");
        EXPECT_EQ(tangents.sigma, 0) << kind << ' ' << n << ' ' << static_cast<int>(sampling);
        for (std::size_t i = 0; i < sample.size(); ++i) ASSERT_EQ(tangents.plane[i].origin, sample.points[i]);
      }
}

/// The surface of the unit cube as a lattice of (n + 1)^2 points a side.
PointSample cube_surface(int n) {
  std::set<std::tuple<double, double, double>> points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (const double side : {0.0, 1.0}) {
        const double a = static_cast<double>(i) / n, b = static_cast<double>(j) / n;
        points.insert({side, a, b}), points.insert({a, side, b}), points.insert({a, b, side});
      }
  PointSample sample;
  for (const auto& [x, y, z] : points) sample.points.push_back({x, y, z});
  return sample;
}

TEST(TangentJet, SharpEdgesAreNeitherSmoothedNorDropped) {
  for (const int n : {5, 8, 15, 40}) {
    const PointSample cube = test::moved(cube_surface(n), 1, {});
    const Tangents tangents = tangents_of(cube);
    EXPECT_EQ(tangents.sigma, 0) << n;
    EXPECT_EQ(dropped(tangents, 0, cube.size()), 0U) << n;
  }
}

TEST(TangentJet, SigmaIsThatOfTheNoise) {
  for (const char* kind : {"torus", "ellipsoid", "genus5"})
    for (const double noise : {0.001, 0.01}) {
      const double truth = noise * norm(extent(shape(kind, 6000)));
      const Tangents tangents = tangents_of(shape(kind, 6000, Sampling::uniform, noise), "smooth=off");
      EXPECT_NEAR(tangents.sigma, truth, 0.2 * truth) << kind << ' ' << noise;
    }
}

TEST(TangentJet, SmoothingBringsPointsAndNormalsNearerToTheShape) {
  for (const char* kind : {"torus", "ellipsoid"}) {
    const PointSample sample = shape(kind, 4000, Sampling::uniform, 0.003);
    const Tangents off = tangents_of(sample, "smooth=off"), on = tangents_of(sample);
    EXPECT_GT(off.sigma, 0) << kind;
    EXPECT_LT(root_mean_square_distance(kind, on), 0.5 * root_mean_square_distance(kind, off)) << kind;
    EXPECT_LT(mean_error(kind, on), 0.5 * mean_error(kind, off)) << kind;
  }
}

TEST(TangentJet, SmoothingOfNoiseThatIsNotThereMovesNothingFar) {
  const PointSample sample = shape("torus", 6000);
  const Tangents on = tangents_of(sample, "smooth=on");
  for (std::size_t i = 0; i < sample.size(); ++i)
    ASSERT_LT(distance(on.plane[i].origin, sample.points[i]), 0.05 * 0.05);  // a twentieth of the spacing
}

TEST(TangentJet, OriginsArePairwiseDistinct) {
  for (const double noise : {0.001, 0.01}) {
    const Tangents tangents = tangents_of(shape("torus", 3000, Sampling::grid, noise));
    std::set<std::tuple<double, double, double>> places;
    for (const TangentPlane& plane : tangents.plane) places.insert({plane.origin.x, plane.origin.y, plane.origin.z});
    EXPECT_EQ(places.size(), tangents.plane.size());
  }
}

TEST(TangentJet, PointsThatComeToRestAtOnePlaceArePutBack) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  // 0 and 1 meet at (9, 9, 9); 2 comes to rest where 3 was put back to; 3 meets 4.
  std::vector<TangentPlane> planes{{{9, 9, 9}}, {{9, 9, 9}}, {{3, 0, 0}}, {{8, 8, 8}}, {{8, 8, 8}}};
  EXPECT_EQ(separate(planes, points), 5U);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(planes[i].origin, points[i]);
}

// ---- outliers

PointSample with_outliers(PointSample sample, double share, std::uint64_t seed) {
  test::Random random(seed);
  const Vec3 size = extent(sample);
  const std::size_t honest = sample.size();
  Vec3 low = sample.points[0];
  for (const Vec3& p : sample.points) low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(share * static_cast<double>(honest)); ++i)
    sample.points.push_back(low +
                            Vec3{random.uniform() * size.x, random.uniform() * size.y, random.uniform() * size.z});
  return sample;
}

TEST(TangentJet, OutliersOffTheSurfaceAreDroppedAndNoOtherPoint) {
  for (const char* kind : {"torus", "ellipsoid", "genus5"})
    for (const double share : {0.01, 0.05}) {
      const PointSample honest = shape(kind, 6000), sample = with_outliers(honest, share, 5);
      Context context;
      const Tangents tangents = JetTangents(OptionValues(jet_options)).estimate(sample, context);
      EXPECT_EQ(dropped(tangents, 0, honest.size()), 0U) << kind;
      for (std::size_t i = honest.size(); i < sample.size(); ++i) {
        if (test::distance_off_shape(kind, sample.points[i]) < 2 * context.measures["spacing"]) continue;
        EXPECT_EQ(tangents.state[i], PointState::dropped) << kind << ' ' << i;
      }
      EXPECT_EQ(context.measures["outliers"], static_cast<double>(dropped(tangents, 0, sample.size())));
    }
}

TEST(TangentJet, OutliersInNoiseAreDroppedAndTheNoiseIsNot) {
  const PointSample honest = shape("torus", 6000, Sampling::uniform, 0.003), sample = with_outliers(honest, 0.05, 6);
  const Tangents tangents = tangents_of(sample);
  const double truth = 0.003 * norm(extent(shape("torus", 6000)));
  EXPECT_NEAR(tangents.sigma, truth, 0.2 * truth);
  EXPECT_EQ(dropped(tangents, 0, honest.size()), 0U);
  // A few that came to lie together remain.
  std::size_t off = 0, missed = 0;
  for (std::size_t i = honest.size(); i < sample.size(); ++i) {
    if (test::distance_off_shape("torus", sample.points[i]) < 8 * truth) continue;
    ++off;
    missed += tangents.state[i] != PointState::dropped;
  }
  EXPECT_LT(50 * missed, off);
}

TEST(TangentJet, ASparseSideOfASurfaceIsNoOutlier) {
  const PointSample sample = test::torus(10000, 1, 10);  // densities 1 : 100
  EXPECT_EQ(dropped(tangents_of(sample), 0, sample.size()), 0U);
  EXPECT_GT(dropped(tangents_of(sample, "outliers=distance"), 0, sample.size()), 100U);
  EXPECT_EQ(dropped(tangents_of(sample, "outliers=off"), 0, sample.size()), 0U);
}

TEST(TangentJet, ASampleThatIsNoSurfaceIsNotDroppedWhole) {
  const PointSample cube = test::cube(3000, 1);
  EXPECT_LT(dropped(tangents_of(cube), 0, cube.size()), cube.size() / 2);
}

// ---- invariance

TEST(TangentJet, MovesTurnsAndScalesWithTheSample) {
  for (const PointSample& sample :
       {shape("trefoil", 3000), shape("torus", 1000, Sampling::uniform, 0.005),
        with_outliers(shape("torus", 3000), 0.05, 1), shape("ellipsoid", 3000, Sampling::grid)}) {
    // Of more than 1,000 points the noise looks at some along a curve that does not turn with the sample.
    const Tangents one = tangents_of(sample);
    for (const double scale : {1e-6, 1e6}) {
      const Tangents other = tangents_of(test::moved(sample, scale, scale * Vec3{1, -2, 3}));
      EXPECT_EQ(other.state, one.state);
      EXPECT_NEAR(other.sigma, scale * one.sigma, 1e-6 * scale * one.sigma);
      PointSample normals, origins;
      for (const TangentPlane& plane : one.plane)
        normals.points.push_back(plane.normal), origins.points.push_back(plane.origin);
      normals = test::moved(normals, 1, {});
      origins = test::moved(origins, scale, scale * Vec3{1, -2, 3});
      for (std::size_t i = 0; i < sample.size(); ++i) {
        ASSERT_LT(angle(other.plane[i].normal, normals.points[i]), 1e-6);
        ASSERT_LT(distance(other.plane[i].origin, origins.points[i]), 1e-8 * scale);
      }
    }
  }
}

TEST(TangentJet, DoesNotDependOnTheOrderOfPoints) {
  for (const PointSample& sample :
       {shape("torus", 2000, Sampling::uniform, 0.005), shape("torus", 2000, Sampling::grid),
        with_outliers(shape("trefoil", 4000), 0.05, 2)}) {
    const std::vector<Index> order = test::permutation(sample.size(), 3);
    const Tangents one = tangents_of(sample), other = tangents_of(test::permuted(sample, order));
    EXPECT_NEAR(other.sigma, one.sigma, 1e-9 * one.sigma);
    for (std::size_t i = 0; i < order.size(); ++i) {
      ASSERT_EQ(other.state[i], one.state[order[i]]);
      ASSERT_LT(angle(other.plane[i].normal, one.plane[order[i]].normal), 1e-7);
      ASSERT_LT(distance(other.plane[i].origin, one.plane[order[i]].origin), 1e-9);
    }
  }
}

}  // namespace
}  // namespace geodrome
