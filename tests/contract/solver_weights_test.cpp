// SPDX-License-Identifier: MIT
// Every solver that takes weights of faces: values against formulas, paths, the audit.
#include <algorithm>
#include <numeric>

#include "contract/solver_contract.hpp"
#include "engine/report/common_face.hpp"
#include "geodrome/engine/audit.hpp"

namespace geodrome::test {
namespace {

template <class Weight>
MeshPtr weighted(const MeshPtr& mesh, Weight&& weight) {
  std::vector<double> weights;
  for (Index f = 0; f < mesh->face_count(); ++f) {
    const auto [p, q, r] = mesh->corners(f);
    weights.push_back(weight((p + q + r) / 3));
  }
  return std::make_shared<const SurfaceMesh>(std::vector<Vec3>(mesh->positions().begin(), mesh->positions().end()),
                                             std::vector<Triangle>(mesh->triangles().begin(), mesh->triangles().end()),
                                             std::move(weights));
}

MeshPtr with_random_weights(const MeshPtr& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return weighted(mesh, [&](const Vec3&) { return 0.5 + 4.5 * uniform(random); });
}

/// Two half planes that meet at x = 0, where a unit costs `left` and `right`, left being the dearer.
struct HalfPlanes {
  double left, right;

  double cost(const Vec3& p, const Vec3& q) const {
    if (p.x > q.x) return cost(q, p);
    const double dy = std::abs(p.y - q.y);
    if (p.x >= 0) return right * distance(p, q);
    if (q.x <= 0) {
      // Straight, or to the border at the critical angle, along it and back.
      const double sine = right / left, cosine = std::sqrt(1 - sine * sine), depth = -p.x - q.x;
      const double by_border =
          dy * cosine >= depth * sine ? left * depth * cosine + right * dy : std::numeric_limits<double>::infinity();
      return std::min(left * distance(p, q), by_border);
    }
    // Fermat: the least over where the border is crossed.
    double low = 0, high = dy;
    const auto through = [&](double y) { return left * std::hypot(p.x, y) + right * std::hypot(q.x, dy - y); };
    for (int step = 0; step < 200; ++step) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (through(a) < through(b) ? high : low) = through(a) < through(b) ? b : a;
    }
    return through(low);
  }
};

class SolverWeights : public SolverContract {
 protected:
  void SetUp() override {
    if (!has(weights)) GTEST_SKIP() << plugin().name << " does not provide weights";
  }
  /// A solver without a factor may be too long by any amount.
  void expect_half_planes(const MeshPtr& plane, const HalfPlanes& half, Index step) {
    const MeshPtr mesh = weighted(plane, [&](const Vec3& p) { return p.x < 0 ? half.left : half.right; });
    Running running(plugin(), mesh);
    for (Index from = 0; from < mesh->vertex_count(); from += step) {
      const auto values = running.run({{mesh->at_vertex(from)}}).vertices();
      for (Index to = 0; to < mesh->vertex_count(); ++to)
        expect_distance(values[to], half.cost(mesh->positions()[from], mesh->positions()[to]), 12 * half.left, "pair");
    }
  }
};

TEST_P(SolverWeights, OneWeightForAllIsAScale) {
  const MeshPtr mesh = terrain(10, 2, 91), heavy = weighted(mesh, [](const Vec3&) { return 2.5; });
  if (!reference()) GTEST_SKIP() << "nothing to compare with";
  Running running(plugin(), heavy), truth(*reference(), mesh);
  for (const Index from : {0, 47, 99}) {
    const auto values = copy(running.run({{heavy->at_vertex(from)}}).vertices());
    const auto wanted = truth.run({{mesh->at_vertex(from)}}).vertices();
    for (Index to = 0; to < mesh->vertex_count(); ++to) expect_distance(values[to], 2.5 * wanted[to], 60, "vertex");
  }
}

TEST_P(SolverWeights, LightRefractsBetweenHalfPlanes) {
  const MeshPtr plane = mapped(plane_grid(8, true), [](const Vec3& p) { return p - Vec3{4, 0, 0}; });
  for (const double left : {1.2, 2.0, 10.0}) expect_half_planes(plane, {left, 1}, 7);
}

/// Corridors of needles: the border is reached between vertices.
TEST_P(SolverWeights, LightRefractsBetweenStretchedHalfPlanes) {
  const MeshPtr plane = mapped(plane_grid(6, true), [](const Vec3& p) { return Vec3{p.x - 3, 5 * p.y, 0}; });
  for (const double left : {1.5, 4.0}) expect_half_planes(plane, {left, 1}, 5);
}

TEST_P(SolverWeights, ScaleWithDistances) {
  const MeshPtr mesh = with_random_weights(terrain(9, 2, 93), 95);
  std::vector<double> weights(mesh->face_weights().begin(), mesh->face_weights().end());
  for (double& weight : weights) weight *= 1024;
  const MeshPtr heavy = std::make_shared<const SurfaceMesh>(
      std::vector<Vec3>(mesh->positions().begin(), mesh->positions().end()),
      std::vector<Triangle>(mesh->triangles().begin(), mesh->triangles().end()), std::move(weights));
  const auto plain = copy(Running(plugin(), mesh).run({{mesh->at_vertex(40)}}).vertices());
  const auto values = copy(Running(plugin(), heavy).run({{heavy->at_vertex(40)}}).vertices());
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(values[v] / 1024, plain[v], rounding * 100);
}

/// A dearer face makes no way shorter, and a way over it longer by no more than the face.
TEST_P(SolverWeights, GrowWithWeights) {
  const MeshPtr mesh = with_random_weights(bumpy_torus(14, 8, 0.1, 97), 99);
  std::vector<double> weights(mesh->face_weights().begin(), mesh->face_weights().end());
  for (double& weight : weights) weight *= 1.5;
  weights[3] *= 2;
  const MeshPtr heavy = std::make_shared<const SurfaceMesh>(
      std::vector<Vec3>(mesh->positions().begin(), mesh->positions().end()),
      std::vector<Triangle>(mesh->triangles().begin(), mesh->triangles().end()), std::move(weights));
  const double factor = std::isfinite(plugin().factor) ? plugin().factor : 1;
  const auto plain = copy(Running(plugin(), mesh).run({{mesh->at_vertex(11)}}).vertices());
  const auto values = copy(Running(plugin(), heavy).run({{heavy->at_vertex(11)}}).vertices());
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    EXPECT_GE(values[v] * factor, 1.5 * plain[v] - rounding * 30);
    EXPECT_LE(values[v], 3 * plain[v] * factor + rounding * 30);
  }
}

TEST_P(SolverWeights, PathsCostWhatTheDistanceSays) {
  GEODROME_NEEDS(any_point | paths | path_is_distance);
  const MeshPtr mesh = with_random_weights(terrain(10, 1.5, 101), 103);
  Running running(plugin(), mesh);
  const CommonFace common(*mesh);
  const ShortestPathMap& map = running.map({{mesh->at_vertex(5)}, {mesh->at_vertex(77)}});
  std::mt19937_64 random(105);
  std::vector<SurfacePoint> path;
  for (int i = 0; i < 60; ++i) {
    const SurfacePoint point = random_point(*mesh, random);
    map.path(point, path);
    double cost = 0;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      const auto step = common.straight(path[k], path[k + 1]);
      ASSERT_TRUE(step) << "step " << k << " leaves the surface";
      cost += *step;
    }
    EXPECT_NEAR(cost, map.at(point).value, rounding * 60);
  }
}

TEST_P(SolverWeights, PassTheAudit) {
  GEODROME_NEEDS(any_point | paths);
  const MeshPtr mesh = with_random_weights(bumpy_torus(14, 8, 0.08, 107), 109);
  Running running(plugin(), mesh);
  const std::vector<Source> sources{{mesh->at_vertex(11)}, {mesh->at_vertex(80), 0.3}};
  const AuditResult result =
      audit(*mesh, sources, running.map(sources), plugin().provides, {.factor = plugin().factor, .points_per_edge = 3});
  EXPECT_GT(result.paths, 0u);
  EXPECT_LE(result.worst_lipschitz, rounding) << result.where;
  EXPECT_LE(result.worst_path, rounding) << result.where;
}

INSTANTIATE_TEST_SUITE_P(Every, SolverWeights, testing::ValuesIn(discovered<ShortestPathSolver>()), plugin_name);

}  // namespace
}  // namespace geodrome::test
