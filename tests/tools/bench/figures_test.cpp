// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "engine/report/memory.hpp"
#include "engine/surface/off_surface.hpp"
#include "tools/bench/samples/distance_errors.hpp"
#include "tools/bench/samples/disturb.hpp"
#include "tools/bench/samples/hausdorff.hpp"
#include "tools/bench/samples/manifold_task.hpp"
#include "tools/bench/samples/sample_case.hpp"
#include "tools/bench/samples/topology_table.hpp"
#include "tools/bench/solvers/fit.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::bench {
namespace {

/// A square of the plane z = `height` with sides from 0 to `side`.
MeshPtr square(double side, double height) {
  const std::vector<Vec3> corners{{0, 0, height}, {side, 0, height}, {side, side, height}, {0, side, height}};
  return std::make_shared<const SurfaceMesh>(corners, std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST(SurfaceGap, OfParallelSquaresIsTheirDistanceBothWays) {
  const MeshPtr low = square(1, 0), high = square(1, 0.3);
  for (const SurfaceGap& gap : {surface_gap(low, high, 1000, 1), surface_gap(high, low, 1000, 1)}) {
    EXPECT_NEAR(gap.largest, 0.3, 1e-12);
    EXPECT_NEAR(gap.mean, 0.3, 1e-12);
  }
}

TEST(SurfaceGap, IsLargeOnlyFromTheSurfaceThatReachesFurther) {
  EXPECT_NEAR(surface_gap(square(2, 0), square(1, 0), 1000, 1).largest, std::sqrt(2.0), 1e-12);  // at a corner
  EXPECT_NEAR(surface_gap(square(1, 0), square(2, 0), 1000, 1).largest, 0, 1e-12);
}

/// The mean distance of a point of [0, 2]^2 from [0, 1]^2, by numerical integration: uniform by area, or it would
/// differ.
TEST(SurfaceGap, DrawsPointsUniformlyByArea) {
  constexpr int cells = 1000;
  double mean = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double x = 2 * (i + 0.5) / cells, y = 2 * (j + 0.5) / cells;
      mean += std::hypot(std::max(0.0, x - 1), std::max(0.0, y - 1)) / (cells * cells);
    }
  EXPECT_NEAR(surface_gap(square(2, 0), square(1, 0), 100'000, 1).mean, mean, 5e-3);
}

TEST(SurfaceGap, DiagonalIgnoresVerticesOnNoFace) {
  const SurfaceMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, {{0, 1, 2}});
  EXPECT_NEAR(surface_diagonal(mesh), std::sqrt(2.0), 1e-15);
}

TEST(Disturb, OutliersFollowThePointsAndFillTheEnlargedBox) {
  const PointSample corners{{{0, 0, 0}, {2, 0, 1}, {1, 4, 0.5}}};
  const PointSample made = with_outliers(corners, 1000, 5);
  ASSERT_EQ(made.size(), 3003u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(made.points[i], corners.points[i]);
  Vec3 low{9, 9, 9}, high{-9, -9, -9};
  for (const Vec3& p : made.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  EXPECT_NEAR(low.x, -0.1, 0.01);
  EXPECT_NEAR(high.x, 2.1, 0.01);
  EXPECT_NEAR(low.y, -0.2, 0.02);
  EXPECT_NEAR(high.y, 4.2, 0.02);
  EXPECT_NEAR(low.z, -0.05, 0.005);
  EXPECT_NEAR(high.z, 1.05, 0.005);
}

TEST(Disturb, OutliersAreRoundedToAWholeNumberAndSeeded) {
  const PointSample points = make_sample({"torus", "uniform", 150, 1});
  EXPECT_EQ(with_outliers(points, 0.01, 1).size(), 152u);
  EXPECT_EQ(with_outliers(points, 0.01, 1).points, with_outliers(points, 0.01, 1).points);
  EXPECT_NE(with_outliers(points, 0.01, 1).points.back(), with_outliers(points, 0.01, 2).points.back());
}

TEST(Disturb, JitterMovesEveryCoordinateByAtMostItsSize) {
  const PointSample exact = make_sample({"torus", "grid", 200, 1}), moved = make_sample({"torus", "jittered", 200, 1});
  ASSERT_EQ(exact.size(), moved.size());
  double largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Vec3 by = moved.points[i] - exact.points[i];
    for (const double d : {by.x, by.y, by.z}) largest = std::max(largest, std::abs(d));
  }
  EXPECT_LE(largest, 1.0000001e-7);
  EXPECT_GE(largest, 0.9e-7);
}

TEST(FittedExponent, OfAPowerLawIsItsExponent) {
  const std::vector<double> x{0.1, 0.2, 0.5, 0.7};
  std::vector<double> y;
  for (const double value : x) y.push_back(3 * std::pow(value, 2.5));
  EXPECT_NEAR(fitted_exponent(x, y), 2.5, 1e-12);
}

TEST(FittedExponent, OfScatteredPointsIsTheLeastSquares) {
  const double e = std::exp(1.0);  // (0, 0), (1, 2), (2, 1) in logarithms: slope 1/2
  EXPECT_NEAR(fitted_exponent(std::vector<double>{1, e, e * e}, std::vector<double>{1, e * e, e}), 0.5, 1e-12);
}

TEST(FittedExponent, OfOnePointIsNone) {
  EXPECT_TRUE(std::isnan(fitted_exponent(std::vector<double>{2}, std::vector<double>{3})));
}

TEST(DistanceErrors, TellOverFromUnderAndFarFromNear) {
  const std::vector<std::vector<double>> truth{{0, 0.1, 1, 4, 10}}, computed{{0.5, 0.2, 7, 4.4, 8}};
  const DistanceErrors errors = distance_errors(truth, computed);
  EXPECT_EQ(errors.far.pairs, 2u);
  EXPECT_NEAR(errors.far.mean, 0.15, 1e-12);
  EXPECT_NEAR(errors.far.mean_over, 0.1, 1e-12);
  EXPECT_NEAR(errors.far.mean_under, 0.2, 1e-12);
  EXPECT_NEAR(errors.far.largest_under, 0.2, 1e-12);
  EXPECT_EQ(errors.near.pairs, 1u);
  EXPECT_NEAR(errors.near.largest_over, 1, 1e-12);
}

/// 100,000 probes find the largest hole of a lattice of N columns and M rows: half the diagonal of its outermost cells.
TEST(ManifoldEpsilon, OfALatticeIsItsLargestHole) {
  const PointSample lattice = make_sample({"torus", "grid", 1000, 1});  // 50 columns, 20 rows
  ASSERT_EQ(lattice.size(), 1000u);
  const double column = 1.4 * 2 * 3.14159265 / 50, row = 0.4 * 2 * 3.14159265 / 20;
  EXPECT_NEAR(manifold_epsilon("torus", lattice, 1), 0.5 * std::hypot(column, row) / 0.4, 0.01);
}

TEST(MemoryPeak, GrowsByWhatIsTouchedAndCanBeReset) {
  constexpr std::size_t block = 100'000'000;
  if (memory_peak() == 0) GTEST_SKIP() << "/proc/self/status does not tell";
  if (!reset_memory_peak()) GTEST_SKIP() << "/proc/self/clear_refs cannot be written";
  const std::size_t before = memory_peak();
  // Not from the heap, which need not give back what is freed.
  void* touched = mmap(nullptr, block, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(touched, MAP_FAILED);
  std::memset(touched, 1, block);
  munmap(touched, block);
  EXPECT_GT(memory_peak(), before + block * 9 / 10);
  reset_memory_peak();
  EXPECT_LT(memory_peak(), before + block / 2);
}

TEST(TopologyTable, SheetsAreAFamilyOfTheirOwnAndComeInLooseLattices) {
  TableChoice choice;
  choice.shapes = {"torus", "cut-torus", "s-curve"}, choice.points = {800}, choice.seeds = {1, 2};
  EXPECT_EQ(cases_of("sheets", choice).size(), 2u + 2 + 1 + 2 + 2);
  for (const SampleCase& c : cases_of("sheets", choice)) EXPECT_EQ(c.shape, "s-curve");
  for (const char* family : {"clean", "boundary"})
    for (const SampleCase& c : cases_of(family, choice)) EXPECT_NE(c.shape, "s-curve") << family;
}

TEST(SheetErrors, AreWrongOnlyIfPartsAreJoinedOrVerticesTooNear) {
  SheetErrors errors;
  errors.short_vertices = 0.019;
  EXPECT_EQ(how_wrong(errors), "");
  errors.short_vertices = 0.05;
  EXPECT_EQ(how_wrong(errors), "vertices are 5 % too near to each other");
  errors.shortcuts = 3;
  EXPECT_EQ(how_wrong(errors), "3 edges join two parts of the sheet");
}

TEST(TopologyTable, ExactLatticesComeOnceAndCutShapesOnlyWithABoundary) {
  TableChoice choice;
  choice.shapes = {"torus", "cut-torus"}, choice.points = {5000}, choice.seeds = {1, 2, 3};
  EXPECT_EQ(cases_of("clean", choice).size(), 3u + 3 + 1 + 3);
  EXPECT_EQ(cases_of("boundary", choice).size(), 2 * (3u + 3 + 1 + 3));
  EXPECT_EQ(cases_of("noise", choice).size(), 9u);
  EXPECT_EQ(cases_of("outliers", choice).size(), 6u);
  for (const SampleCase& c : cases_of("noise", choice)) EXPECT_EQ(c.shape, "torus");
  EXPECT_THROW(cases_of("none", choice), OptionError);
}

}  // namespace
}  // namespace geodrome::bench
