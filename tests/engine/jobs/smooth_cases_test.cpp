// SPDX-License-Identifier: MIT
// Samples that a smooth surface is no help for, or only in part: smooth distances are hardly ever worse than flat ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geodrome/engine/input.hpp"
#include "geodrome/engine/session.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/samples.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::testing {
namespace {

/// By how much the mean error may grow.
constexpr double hardly = 1.05;

/// Errors below this are none: on a plane flat distances are exact but for rounding.
constexpr double none = 1e-8;

class SmoothCases : public ::testing::Test {
 protected:
  Matrix distances(DistanceJob job) const {
    job.matrix = folder_ / "d.npy";
    const JobReport report = run_distances(job, silent_observer());
    EXPECT_TRUE(report.broken_promises.empty()) << report.broken_promises.front();
    return read_npy(job.matrix);
  }

  Matrix measured(const std::vector<Vec3>& points, Metric metric) const {
    write_points(folder_ / "p.xyz", points);
    return distances({.input = folder_ / "p.xyz", .settings = {.metric = metric, .threads = 2}, .sources = sources_});
  }

  /// Exact distances of points of a polyhedron.
  Matrix truth_on(const MeshPtr& polyhedron, const std::vector<Vec3>& points) const {
    write_mesh(folder_ / "m.ply", *polyhedron);
    write_points(folder_ / "all.xyz", points);
    std::vector<Vec3> some;
    for (std::size_t i = 0; i < points.size(); i += step_) some.push_back(points[i]);
    write_points(folder_ / "some.xyz", some);
    return distances({.input = folder_ / "m.ply",
                      .settings = {.threads = 2},
                      .sources = "@" + (folder_ / "some.xyz").string(),
                      .targets = "@" + (folder_ / "all.xyz").string()});
  }

  /// The mean relative error of smooth distances above that of flat ones, far pairs only. Wants all invariants.
  double ratio(const std::vector<Vec3>& points, const Matrix& truth) const {
    const Matrix flat = measured(points, Metric::flat), smooth = measured(points, Metric::smooth);
    double flat_sum = 0, smooth_sum = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < truth.rows; ++i) {
      EXPECT_EQ(smooth(i, step_ * i), 0);
      for (std::size_t j = 0; j < truth.columns; ++j) {
        const double straight = distance(points[step_ * i], points[j]);
        EXPECT_EQ(std::isfinite(smooth(i, j)), std::isfinite(flat(i, j)));
        if (!std::isfinite(flat(i, j))) continue;
        EXPECT_GE(smooth(i, j), straight * (1 - 1e-15));
        if (truth(i, j) < 0.2) continue;
        ++pairs;
        flat_sum += std::abs(flat(i, j) / truth(i, j) - 1), smooth_sum += std::abs(smooth(i, j) / truth(i, j) - 1);
      }
    }
    EXPECT_GT(flat_sum, 0);
    return smooth_sum / std::max(flat_sum, none * static_cast<double>(pairs));
  }
  double ratio_on(const MeshPtr& polyhedron, const std::vector<Vec3>& points) const {
    return ratio(points, truth_on(polyhedron, points));
  }

  const TemporaryFolder folder_;
  const std::size_t step_ = 500;
  const std::string sources_ = "0:2000:500";
};

MeshPtr box(double height) {
  return test::mapped(test::cube(), [&](const Vec3& p) { return Vec3{p.x, p.y, height * p.z}; });
}

/// Uniform on a mesh by area.
std::vector<Vec3> points_on(const SurfaceMesh& mesh, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> upto;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    upto.push_back((upto.empty() ? 0 : upto.back()) + norm(cross(q - p, r - p)));
  }
  std::vector<Vec3> points;
  while (points.size() < count) {
    const auto face = std::ranges::lower_bound(upto, test::uniform(random) * upto.back()) - upto.begin();
    double a = test::uniform(random), b = test::uniform(random);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    points.push_back(mesh.position({static_cast<Index>(face), {1 - a - b, a, b}}));
  }
  return points;
}

/// Two rectangles that meet at an angle, which is how far one is turned against the other.
MeshPtr roof(double turned) {
  const double x = std::cos(turned / 2), z = -std::sin(turned / 2);
  return test::make({{-x, 0, z}, {0, 0, 0}, {x, 0, z}, {-x, 2, z}, {0, 2, 0}, {x, 2, z}},
                    {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}});
}

std::vector<Vec3> noisy(const std::vector<Vec3>& points, double sigma, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> moved;
  for (const Vec3& p : points) {
    const auto normal = [&] {  // variance 1, from twelve uniform numbers
      double sum = -6;
      for (int i = 0; i < 12; ++i) sum += test::uniform(random);
      return sigma * sum;
    };
    const double x = normal(), y = normal(), z = normal();
    moved.push_back({p.x + x, p.y + y, p.z + z});
  }
  return moved;
}

Matrix arcs(const std::vector<Vec3>& points, std::size_t step) {
  Matrix truth;
  truth.columns = points.size();
  for (std::size_t i = 0; i < points.size(); i += step, ++truth.rows)
    for (const Vec3& q : points) truth.values.push_back(std::atan2(norm(cross(points[i], q)), dot(points[i], q)));
  return truth;
}

TEST_F(SmoothCases, SharpEdges) {
  const std::vector<Vec3> points = points_on(*box(1), 2000, 1);
  EXPECT_LT(ratio_on(box(1), points), hardly);
  EXPECT_LT(ratio_on(box(1), noisy(points, 0.002, 2)), hardly);
}

TEST_F(SmoothCases, ThinPlates) { EXPECT_LT(ratio_on(box(0.2), points_on(*box(0.2), 2000, 1)), hardly); }

TEST_F(SmoothCases, BluntCreasesWithPointsOnThem) {
  for (const double degrees : {10, 30, 45}) {
    const MeshPtr mesh = roof(degrees * std::numbers::pi / 180);
    std::vector<Vec3> points = points_on(*mesh, 1940, 4);
    for (int k = 0; k < 60; ++k) points.push_back({0, 2 * k / 59.0, 0});
    EXPECT_LT(ratio_on(mesh, points), hardly) << degrees;
  }
}

TEST_F(SmoothCases, BordersOfAPlane) {
  const MeshPtr mesh = test::plane_grid(1);
  const std::vector<Vec3> points = points_on(*mesh, 2000, 1);
  EXPECT_LT(ratio_on(mesh, points), hardly) << "points beyond the border of the surface among them";
  for (const double noise : {0.001, 0.005}) EXPECT_LT(ratio_on(mesh, noisy(points, noise, 3)), hardly) << noise;
}

TEST_F(SmoothCases, NoiseOfATenthOfAPercentToOnePercent) {
  const std::vector<Vec3> points = test::sphere(2000, 1).points;
  const Matrix truth = arcs(points, step_);
  for (const double share : {0.001, 0.005, 0.01})
    EXPECT_LT(ratio(noisy(points, share * 2 * std::sqrt(3), 5), truth), hardly) << share;
}

TEST_F(SmoothCases, LimitHoldsWhereSmoothWaysAreShorter) {
  write_points(folder_ / "p.xyz", shapes::sample("genus2", {.points = 3000}).points);
  DistanceJob job{.input = folder_ / "p.xyz", .settings = {.metric = Metric::smooth}, .sources = "0,7,100,999"};
  const Matrix whole = distances(job);
  for (const double limit : {0.3, 0.7, 1.1}) {
    job.max_distance = limit;
    const Matrix limited = distances(job);
    for (std::size_t k = 0; k < whole.values.size(); ++k)
      EXPECT_EQ(limited.values[k], whole.values[k] > limit ? infinity : whole.values[k]);
  }
}

TEST_F(SmoothCases, UnevenSamples) {
  std::mt19937_64 random(8);
  std::vector<Vec3> points;
  for (const Vec3& p : test::sphere(8000, 3).points)
    if (points.size() < 2000 && (p.z > 0 || test::uniform(random) < 0.1)) points.push_back(p);
  EXPECT_LT(ratio(points, arcs(points, step_)), 0.1);
}

TEST_F(SmoothCases, SparseSamples) {
  const std::vector<Vec3> points = test::sphere(2000, 1).points;
  std::vector<Vec3> few;
  for (std::size_t i = 0; i < points.size(); i += 4) few.push_back(points[i]);
  write_points(folder_ / "p.xyz", few);
  double sum[2] = {};
  for (const Metric metric : {Metric::flat, Metric::smooth}) {
    const Matrix d = distances({.input = folder_ / "p.xyz", .settings = {.metric = metric}, .sources = "0,100"});
    const Matrix truth = arcs(few, 100);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < d.columns; ++j)
        if (truth(i, j) > 0.2) sum[metric == Metric::smooth] += std::abs(d(i, j) / truth(i, j) - 1);
  }
  EXPECT_LT(sum[1], 0.05 * sum[0]);
}

}  // namespace
}  // namespace geodrome::testing
