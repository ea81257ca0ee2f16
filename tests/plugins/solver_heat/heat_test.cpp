// SPDX-License-Identifier: MIT
#include "tests/plugins/solvers/fixture.hpp"
#include "tests/support/meshes.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

namespace geodrome::test {
namespace {

const Plugin<ShortestPathSolver>& heat() {
  static const Plugin<ShortestPathSolver> solver = load_solver("heat");
  return solver;
}

double mean_error(const MeshPtr& mesh, Index source) {
  const std::vector<double> values = from_vertex(heat(), mesh, source),
                            truth = from_vertex(load_solver("chen_han"), mesh, source);
  double sum = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) sum += std::abs(values[v] - truth[v]);
  return sum / static_cast<double>(truth.size()) / *std::max_element(truth.begin(), truth.end());
}

TEST(Heat, ErrorsAreAFewPercent) {
  for (const char* kind : {"sphere", "bumpy", "noisy-sphere", "jittered-torus", "genus2", "cut-torus"})
    for (const Index source : {0, 100, 500}) {
      const double error = mean_error(shape(kind, 5000, 3), source);
      EXPECT_LT(error, 0.03) << kind << " from vertex " << source;
      EXPECT_GT(error, 1e-4) << kind << " from vertex " << source;  // the peer is another one
    }
}

TEST(Heat, ErrorsFallWithTheEdgesOnASphere) {
  const double coarse = mean_error(shape("sphere", 1280), 7), fine = mean_error(shape("sphere", 20480), 7);
  EXPECT_LT(fine, 0.4 * coarse);
}

/// Each component has a time step and a system of its own: it does not matter how large the others are.
TEST(Heat, ComponentsOfAnySizeDoNotMatterToEachOther) {
  const MeshPtr plain = bumpy_torus(16, 10, 0.05, 3);
  const std::vector<double> alone = from_vertex(heat(), plain, 5);
  const auto scaled = [&](double by) { return mapped(plain, [=](const Vec3& p) { return by * p; }); };
  const MeshPtr mesh = both(scaled(0x1p-60), scaled(0x1p60));
  const auto n = static_cast<Index>(plain->vertex_count());
  const std::vector<double> small = from_vertex(heat(), mesh, 5), large = from_vertex(heat(), mesh, n + 5);
  for (Index v = 0; v < n; ++v) {
    EXPECT_EQ(small[v], 0x1p-60 * alone[v]) << "vertex " << v;
    EXPECT_EQ(large[n + v], 0x1p60 * alone[v]) << "vertex " << v;
    EXPECT_EQ(small[n + v], INFINITY);
    EXPECT_EQ(large[v], INFINITY);
  }
}

/// Holes, needles down to faces without area, several components: distances, or a refusal, never anything else.
TEST(Heat, GivesDistancesOrRefuses) {
  int solved = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const MeshPtr mesh = share(shapes::fuzz_mesh(seed).mesh);
    if (!mesh->manifold() || mesh->face_count() > 2500) continue;
    const Index source = mesh->triangles()[0][0];
    const std::vector<double> truth = from_vertex(load_solver("edge_dijkstra"), mesh, source);
    try {
      const std::vector<double> values = from_vertex(heat(), mesh, source);
      EXPECT_EQ(values[source], 0);
      for (Index v = 0; v < values.size(); ++v)
        EXPECT_TRUE(values[v] >= 0 && std::isfinite(values[v]) == std::isfinite(truth[v]))
            << "seed " << seed << ", vertex " << v << ": " << values[v];
      ++solved;
    } catch (const NumericalError&) {
      ++refused;
    }
  }
  EXPECT_GT(solved, 50);
  EXPECT_GT(refused, 0);
}

TEST(Heat, RefusesWhereHeatIsBelowTheRangeOfNumbers) {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (Index i = 0; i < 900; ++i) {
    positions.push_back({static_cast<double>(i), 0, 0}), positions.push_back({i + 0.5, 0.9, 0});
    if (i == 0) continue;
    triangles.push_back({2 * i - 2, 2 * i, 2 * i - 1}), triangles.push_back({2 * i - 1, 2 * i, 2 * i + 1});
  }
  const MeshPtr strip = make(positions, triangles);
  EXPECT_NEAR(from_vertex(heat(), strip, 900)[0], 450, 5);
  EXPECT_THROW(from_vertex(heat(), strip, 0), NumericalError);
}

/// Far beyond the range CGAL's result is no number at any vertex, not even beside the source. The faces are sound, and
/// the message must not blame them.
TEST(Heat, NamesTheRangeOfNumbersWhereverAStripLeavesIt) {
  for (const Index length : {800, 900, 1000, 1500, 3000}) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    for (Index i = 0; i <= length; ++i) {
      positions.push_back({static_cast<double>(i), 0, 0}), positions.push_back({static_cast<double>(i), 1, 0});
      if (i == 0) continue;
      triangles.push_back({2 * i - 2, 2 * i, 2 * i + 1}), triangles.push_back({2 * i - 2, 2 * i + 1, 2 * i - 1});
    }
    try {
      from_vertex(heat(), make(positions, triangles), 0);
      FAIL() << length << " squares";
    } catch (const NumericalError& error) {
      EXPECT_NE(error.message().find("690"), std::string::npos) << length << ": " << error.what();
      EXPECT_NE(error.remedy().find("coarser"), std::string::npos) << length << ": " << error.what();
      EXPECT_EQ(error.remedy().find("needle"), std::string::npos) << length << ": " << error.what();
    }
  }
}

TEST(Heat, RefusesAFaceWhoseAnglesAreRounding) {
  const MeshPtr mesh = make({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-8, 0}, {0.5, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}});
  try {
    from_vertex(heat(), mesh, 0);
    FAIL() << "was accepted";
  } catch (const NumericalError& error) {
    EXPECT_NE(error.message().find("face 0 is too flat"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace geodrome::test
