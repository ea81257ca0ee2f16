// SPDX-License-Identifier: MIT
#include <numbers>

#include "tests/plugins/solvers/fixture.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

const Plugin<ShortestPathSolver>& fast_marching() {
  static const Plugin<ShortestPathSolver> solver = load_solver("fast_marching");
  return solver;
}

std::vector<double> estimate(const MeshPtr& mesh, const std::vector<Source>& sources) {
  QuietContext context;
  const auto search_of = [&](const ShortestPathSolver& solver) {
    const auto prepared = solver.prepare(mesh, context);
    const auto search = prepared->make_search();
    const auto values = search->run(sources, {}, context).vertices();
    return std::vector<double>(values.begin(), values.end());
  };
  return fast_marching().call(search_of);
}

/// The mean difference over the largest true distance.
double mean_error(const std::vector<double>& values, const std::vector<double>& truth) {
  double sum = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) sum += std::abs(values[v] - truth[v]);
  return sum / static_cast<double>(truth.size()) / *std::max_element(truth.begin(), truth.end());
}

/// Against exact distances on the mesh itself.
double mean_error(const MeshPtr& mesh, Index source) {
  return mean_error(estimate(mesh, {{mesh->at_vertex(source)}}), from_vertex(load_solver("chen_han"), mesh, source));
}

/// On meshes with four times as many faces each, from vertex 7. Near a source no plane front fits, which takes a factor
/// log(1 / h) beside the first order: from 1,280 to 20,480 faces errors fall by a little less than half each time.
void expect_first_order(const std::string& kind) {
  double before = INFINITY;
  for (const std::size_t faces : {1280, 5120, 20480}) {
    const double error = mean_error(shape(kind, faces), 7);
    EXPECT_LT(error, 0.7 * before) << kind << ", " << faces << " faces, before " << before;
    before = error;
  }
  EXPECT_LT(before, 0.005) << kind;
}

TEST(FastMarching, ErrorsFallWithTheEdgesOnAPlane) { expect_first_order("plane"); }
TEST(FastMarching, ErrorsFallWithTheEdgesOnASphere) { expect_first_order("sphere"); }
TEST(FastMarching, ErrorsFallWithTheEdgesOnATorus) { expect_first_order("torus"); }

/// A linear function of slope 1 is its own front: what the stencils make of it is exact, split corners included. It is
/// bent at its ends, where the grid ends, and the bend goes inwards by a row or two a column.
TEST(FastMarching, APlaneFrontStaysPlane) {
  constexpr Index n = 40;
  const MeshPtr mesh = moved(shaken(plane_grid(n, true), 0.3, 5), [](const Vec3& p) { return Vec3{p.x, p.y, 0}; });
  std::vector<Source> sources;
  for (Index v = 0; v <= n; ++v) sources.push_back({mesh->at_vertex(v), mesh->positions()[v].x + 1});
  const std::vector<double> values = estimate(mesh, sources);
  for (Index column = 1; column < 9; ++column)
    for (Index row = 2 * column; row <= n - 2 * column; ++row) {
      const Index v = column * (n + 1) + row;
      EXPECT_NEAR(values[v], mesh->positions()[v].x + 1, 1e-12 * n) << "column " << column << ", row " << row;
    }
}

/// Corners of 135 and 153 degrees at every vertex. Without splitting errors are 5 and 12 % however fine the grid.
TEST(FastMarching, ObtuseCornersAreNoWorse) {
  constexpr Index n = 32, middle = (n + 1) * (n / 2) + n / 2;
  const double acute = mean_error(plane_grid(n), middle);
  for (const double shear : {1.0, 2.0}) {
    const MeshPtr mesh = mapped(plane_grid(n), [=](const Vec3& p) { return Vec3{p.x + shear * p.y, p.y, 0}; });
    EXPECT_LT(mean_error(mesh, middle), 1.1 * acute) << "shear " << shear;
  }
}

TEST(FastMarching, ErrorsAreAFewPercentOnRoughShapes) {
  for (const char* kind : {"bumpy", "noisy-sphere", "jittered-torus", "genus2", "cut-torus"})
    for (const Index source : {0, 100, 500}) {
      const double error = mean_error(shape(kind, 5000, 3), source);
      EXPECT_LT(error, 0.025) << kind << " from vertex " << source;
      EXPECT_GT(error, 1e-4) << kind << " from vertex " << source;  // the peer is another one
    }
}

TEST(FastMarching, FacesOfTheSourceAreExact) {
  std::mt19937_64 random(11);
  for (const MeshPtr& mesh : random_meshes(3))
    for (int k = 0; k < 40; ++k) {
      const SurfacePoint source = random_point(*mesh, random);
      const std::vector<double> values = estimate(mesh, {{source}});
      for (const Index v : mesh->triangles()[source.face]) {
        const double straight = distance(mesh->position(source), mesh->positions()[v]);
        EXPECT_NEAR(values[v], straight, 1e-12) << "face " << source.face << ", vertex " << v;
      }
    }
}

/// Near the border of two sources a plane front may come through vertices of both, so the minimum is met by and large.
TEST(FastMarching, ManySourcesGiveTheMinimumByAndLarge) {
  const MeshPtr mesh = shape("bumpy", 5000);
  const std::vector<Index> at{0, 300, 900, 1700, 2400};
  std::vector<double> nearest(mesh->vertex_count(), INFINITY);
  std::vector<Source> sources;
  for (const Index s : at) {
    sources.push_back({mesh->at_vertex(s)});
    const std::vector<double> alone = estimate(mesh, {sources.back()});
    for (Index v = 0; v < alone.size(); ++v) nearest[v] = std::min(nearest[v], alone[v]);
  }
  const std::vector<double> together = estimate(mesh, sources);
  EXPECT_LT(mean_error(together, nearest), 0.001);
  EXPECT_LT(worst_difference(nearest, together), 0.03);
}

}  // namespace
}  // namespace geodrome::test
