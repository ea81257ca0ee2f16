// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/surface_truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/torus_graph.hpp"
#include "tools/bench/samples/manifold_task.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr double pi = std::numbers::pi;

/// What the truth promises.
constexpr double promised = 1e-12;

SurfaceTruth truth_of(const std::string& shape, std::size_t faces) {
  return SurfaceTruth(shape, faces, PluginHost().load<ShortestPathSolver>("chen_han"));
}

Vec3 torus_point(double u, double v) {
  const double w = 1 + 0.4 * std::cos(v);
  return {w * std::cos(u), w * std::sin(u), 0.4 * std::sin(v)};
}

TEST(SurfaceTruth, OfTheSphereIsTheAngle) {
  SurfaceTruth truth = truth_of("sphere", 5000);
  const std::vector<Vec3> points = shapes::sample("sphere", {.points = 60, .seed = 2}).points;
  truth.start(points[0]);
  for (const Vec3& p : points)
    EXPECT_NEAR(truth.distance(p), std::atan2(norm(cross(points[0], p)), dot(points[0], p)), promised);
}

TEST(SurfaceTruth, OfTheTorusKnowsMeridiansAndTheInnerEquator) {
  SurfaceTruth truth = truth_of("torus", 20'000);
  truth.start(torus_point(0.7, 2.2));
  for (double v = -3; v <= 3; v += 0.5)
    EXPECT_NEAR(truth.distance(torus_point(0.7, 2.2 + v)), 0.4 * std::abs(v), promised) << v;
  truth.start(torus_point(1, pi));
  for (double u = -3; u <= 3; u += 0.5)
    EXPECT_NEAR(truth.distance(torus_point(1 + u, pi)), 0.6 * std::abs(u), promised) << u;
}

/// Its first conjugate point is at the length pi sqrt(r (R + r)); beyond it two paths of the same length pass above and
/// below.
TEST(SurfaceTruth, TheOuterEquatorIsShortestUpToItsConjugatePointAndNotBeyond) {
  SurfaceTruth truth = truth_of("torus", 20'000);
  const double limit = pi * std::sqrt(0.4 * 1.4) / 1.4;
  truth.start(torus_point(0, 0));
  for (const double share : {0.1, 0.5, 0.9, 0.99})
    EXPECT_NEAR(truth.distance(torus_point(share * limit, 0)), 1.4 * share * limit, promised) << share;
  for (const double share : {1.05, 1.2})
    EXPECT_LT(truth.distance(torus_point(share * limit, 0)), 1.4 * share * limit - 1e-5) << share;
}

/// A quarter of a principal ellipse lies in a plane of symmetry and has no conjugate point.
TEST(SurfaceTruth, OfTheEllipsoidKnowsItsPrincipalEllipses) {
  SurfaceTruth truth = truth_of("ellipsoid", 20'000);
  truth.start({1, 0, 0});
  EXPECT_NEAR(truth.distance({0, 0, 0.6}), 1.2763499431699064, promised);  // E(1 - 0.36)
  EXPECT_NEAR(truth.distance({0, 0.8, 0}), 1.4180833944487243, promised);  // E(1 - 0.64)
}

class TruthOfShape : public testing::TestWithParam<std::string> {};

/// Two independent ways to each distance: searches from both ends, on meshes with other vertices.
TEST_P(TruthOfShape, IsTheSameBothWaysFromDifferentMeshesAndKeepsTheTriangleInequality) {
  constexpr std::size_t count = 6;
  const std::vector<Vec3> points = shapes::sample(GetParam(), {.points = count, .seed = 7}).points;
  std::vector<std::vector<double>> fine, coarse;
  for (const auto& [faces, matrix] : {std::pair{20'000, &fine}, {6000, &coarse}}) {
    SurfaceTruth truth = truth_of(GetParam(), static_cast<std::size_t>(faces));
    for (const Vec3& source : points) {
      truth.start(source);
      std::vector<double>& row = matrix->emplace_back();
      for (const Vec3& p : points) row.push_back(truth.distance(p));
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      EXPECT_NEAR(fine[i][j], fine[j][i], promised);
      EXPECT_NEAR(fine[i][j], coarse[i][j], promised);
      for (std::size_t k = 0; k < count; ++k) EXPECT_LE(fine[i][k], fine[i][j] + fine[j][k] + promised);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TruthOfShape, testing::ValuesIn(smooth_shapes()));

/// A shortest geodesic that was missed would show: some path of the graph would be shorter than the truth.
TEST(SurfaceTruth, NoPathOfAFineGraphIsShorter) {
  constexpr double lattice_error = 1.5e-2;  // what few directions cost
  const test::TorusGraph graph(240, 100, 5);
  SurfaceTruth truth = truth_of("torus", 10'000);
  for (const std::size_t source : {0, 37}) {
    truth.start(graph.point(source));
    const std::vector<double> bound = graph.distances(source);
    for (std::size_t i = 0; i < graph.size(); i += 23) {
      const double d = truth.distance(graph.point(i));
      EXPECT_LE(d, bound[i] + promised) << i;
      EXPECT_LE(bound[i], d * (1 + lattice_error)) << i;
    }
  }
}

/// Where the mesh prefers the wrong one of two ways, the other is found: on a mesh so coarse that it often does, the
/// distances are those that a fine one gives.
TEST(SurfaceTruth, NearTheCutLocusTheShorterWayIsFound) {
  SurfaceTruth coarse = truth_of("torus", 1500), fine = truth_of("torus", 40'000);
  coarse.start(torus_point(0, 0)), fine.start(torus_point(0, 0));
  for (double u = 2.9; u <= 3.14; u += 0.06)  // the cut locus is where u = pi, and on the inner side
    for (double v = 2.7; v <= 3.5; v += 0.1)
      EXPECT_NEAR(coarse.distance(torus_point(u, v)), fine.distance(torus_point(u, v)), promised) << u << ' ' << v;
}

TEST(TaskMaker, ChoosesTheSourcesNearPointsAndOthersAndStatesTheAsymmetry) {
  TaskMaker maker("torus", {.faces = 5000, .targets = 20, .near = 10}, PluginHost());
  const ManifoldTask task = maker.make({"torus", "uniform", 4000, 1}, 3);
  ASSERT_EQ(task.sources.size(), 3u);
  EXPECT_LT(task.asymmetry, promised);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(task.targets[i].size(), task.truth[i].size());
    EXPECT_GE(task.targets[i].size(), 27u);  // two sources, 20 and 10, of which few are drawn twice
    EXPECT_TRUE(std::ranges::is_sorted(task.targets[i]));
    EXPECT_FALSE(std::ranges::binary_search(task.targets[i], task.sources[i]));
    EXPECT_TRUE(std::ranges::binary_search(task.targets[i], task.sources[(i + 1) % 3]));
    EXPECT_GE(std::ranges::count_if(task.truth[i], [](double d) { return d < 0.2; }), 9);
  }
}

TEST(TaskMaker, MeasuresNoisyPointsWhereTheyWereBeforeTheNoise) {
  TaskMaker maker("torus", {.faces = 5000, .targets = 20, .near = 10}, PluginHost());
  const ManifoldTask clean = maker.make({"torus", "uniform", 500, 1}, 2);
  const ManifoldTask noisy = maker.make({"torus", "uniform", 500, 1, 0.01}, 2);
  EXPECT_EQ(noisy.truth, clean.truth);
  EXPECT_EQ(noisy.targets, clean.targets);
  EXPECT_NE(noisy.sample.points, clean.sample.points);
}

TEST(TaskMaker, RefusesPointsBesideTheShapeAndUnknownShapes) {
  EXPECT_THROW(TaskMaker("torus", {.faces = 1000}, PluginHost()).make({"torus", "jittered", 100, 1}, 1), OptionError);
  EXPECT_THROW(TaskMaker("plane", {}, PluginHost()), OptionError);
}

}  // namespace
}  // namespace geodrome::bench
