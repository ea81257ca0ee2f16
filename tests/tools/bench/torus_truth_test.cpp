// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/torus_truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/torus_graph.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr double pi = std::numbers::pi;

/// What the truth promises.
constexpr double promised = 1e-7;

std::vector<TorusPoint> sampled(std::size_t count, std::uint64_t seed) {
  std::vector<TorusPoint> points;
  for (const Vec3& p : shapes::sample("torus", {.points = count, .seed = seed}).points)
    points.push_back(torus_point(p));
  return points;
}

/// The graph's lengths and the truth at every node of its lattice, from one of them.
struct Compared {
  double shorter_than_truth = 0;  ///< greatest truth - graph: a shorter path than the truth knows
  double longer_than_truth = 0;   ///< greatest (graph - truth) / truth
};

Compared compare_with_graph(const test::TorusGraph& graph, std::size_t source) {
  std::vector<TorusPoint> nodes;
  for (std::size_t i = 0; i < graph.size(); ++i) nodes.push_back(graph.point(i));
  const std::vector<double> truth = torus_distances(nodes[source], nodes), bound = graph.distances(source);
  Compared result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    result.shorter_than_truth = std::max(result.shorter_than_truth, truth[i] - bound[i]);
    if (i != source) result.longer_than_truth = std::max(result.longer_than_truth, (bound[i] - truth[i]) / truth[i]);
  }
  return result;
}

TEST(TorusTruth, AnglesAndPositionsAreInverse) {
  for (const TorusPoint& p : sampled(50, 1)) {
    const TorusPoint back = torus_point(torus_position(p));
    EXPECT_NEAR(std::remainder(back.u - p.u, 2 * pi), 0, 1e-14);
    EXPECT_NEAR(std::remainder(back.v - p.v, 2 * pi), 0, 1e-14);
  }
}

TEST(TorusTruth, MeridiansAreShortest) {
  std::vector<TorusPoint> targets;
  for (double v = -3; v <= 3; v += 0.25) targets.push_back({0.7, 2.2 + v});
  const std::vector<double> d = torus_distances({0.7, 2.2}, targets);
  for (std::size_t i = 0; i < targets.size(); ++i)
    EXPECT_NEAR(d[i], torus_tube * std::abs(targets[i].v - 2.2), promised) << targets[i].v;
}

TEST(TorusTruth, TheInnerEquatorIsShortest) {
  std::vector<TorusPoint> targets;
  for (double u = -3; u <= 3; u += 0.25) targets.push_back({1 + u, pi});
  const std::vector<double> d = torus_distances({1, pi}, targets);
  for (std::size_t i = 0; i < targets.size(); ++i)
    EXPECT_NEAR(d[i], (torus_ring - torus_tube) * std::abs(targets[i].u - 1), promised) << targets[i].u;
}

/// Its first conjugate point is at the length pi sqrt(r (R + r)).
TEST(TorusTruth, TheOuterEquatorIsShortestUpToItsConjugatePointAndNotBeyond) {
  const double radius = torus_ring + torus_tube, limit = pi * std::sqrt(torus_tube * radius) / radius;
  std::vector<TorusPoint> targets;
  for (const double share : {0.1, 0.5, 0.9, 0.99, 1.05, 1.2}) targets.push_back({share * limit, 0});
  const std::vector<double> d = torus_distances({0, 0}, targets);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(d[i], radius * targets[i].u, promised) << targets[i].u;
  for (std::size_t i = 4; i < 6; ++i) EXPECT_LT(d[i], radius * targets[i].u - 1e-5) << targets[i].u;
}

TEST(TorusTruth, IsSymmetricAndKeepsTheTriangleInequality) {
  const std::vector<TorusPoint> points = sampled(4, 7);
  std::vector<std::vector<double>> d;
  for (const TorusPoint& source : points) d.push_back(torus_distances(source, points));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      EXPECT_NEAR(d[i][j], d[j][i], promised);
      for (std::size_t k = 0; k < points.size(); ++k) EXPECT_LE(d[i][k], d[i][j] + d[j][k] + promised);
    }
}

TEST(TorusTruth, FinerRaysAndStepsChangeLessThanPromised) {
  const std::vector<TorusPoint> points = sampled(2000, 3);
  const std::vector<double> usual = torus_distances(points[0], points);
  const std::vector<double> finer = torus_distances(points[0], points, {.rays = 20000, .step = 0.01});
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(usual[i], finer[i], promised);
}

/// A shortest geodesic that shooting missed would show: some path of the graph would be shorter than the truth.
TEST(TorusTruth, NoPathOfAFineGraphIsShorter) {
  constexpr double lattice_error = 1.5e-2;  // what few directions cost; measured: 1.2e-2
  const test::TorusGraph graph(240, 100, 5);
  for (const std::size_t row : {0, 37}) {
    const Compared found = compare_with_graph(graph, row);
    EXPECT_LE(found.shorter_than_truth, promised) << row;
    EXPECT_LE(found.longer_than_truth, lattice_error) << row;
  }
}

}  // namespace
}  // namespace geodrome::bench
