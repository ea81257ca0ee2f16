// SPDX-License-Identifier: MIT
// Vertices that nearly coincide: exact solvers on meshes whose vertices were split, against the mesh before.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/small_meshes.hpp"
#include "tools/shapes/split_vertices.hpp"

namespace geodrome::test {
namespace {

MeshPtr base(std::uint64_t seed) {
  switch (seed % 4) {
    case 0:
      return shapes::small::plane_grid(6);
    case 1:
      return shapes::small::terrain(5, 1.5, seed);
    case 2:
      return shapes::small::cube();
    default:
      return shapes::small::bumpy_torus(7, 6, 0.1, seed);
  }
}

class NearVertices : public testing::TestWithParam<std::string> {
 protected:
  Plugin<ShortestPathSolver> solver_ = load_solver(GetParam());
  QuietContext context_;

  std::vector<std::vector<double>> rows(const MeshPtr& mesh, std::size_t count) {
    const auto prepared = solver_.object->prepare(mesh, context_);
    const auto search = prepared->make_search();
    std::vector<std::vector<double>> rows;
    for (Index s = 0; s < count; ++s) {
      const Source source{mesh->at_vertex(s)};
      const auto values = search->run({&source, 1}, {}, context_).vertices();
      rows.emplace_back(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return rows;
  }

  /// Tells the seed of a mesh on which a distance is off by more than the splits explain.
  std::string worst_of(double gap, std::uint64_t first, std::uint64_t count) {
    std::string wrong;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
      const MeshPtr before = base(seed);
      const std::size_t vertices = before->vertex_count(), splits = 10 + seed % 50;
      const MeshPtr mesh = share(shapes::split_vertices(*before, splits, gap, seed));
      const auto right = rows(before, vertices), found = rows(mesh, vertices);
      for (std::size_t s = 0; s < vertices; ++s)
        for (std::size_t t = 0; t < vertices; ++t) {
          const double off = std::abs(found[s][t] - right[s][t]);
          if (off <= 2 * gap * static_cast<double>(mesh->vertex_count() - vertices) + 1e-12 * right[s][t]) continue;
          wrong += " seed " + std::to_string(seed) + ": " + std::to_string(s) + " to " + std::to_string(t) +
                   " off by " + std::to_string(off / right[s][t]);
          s = vertices - 1, t = vertices;
        }
    }
    return wrong;
  }
};

TEST_P(NearVertices, InOnePlaceChangeNoDistance) { EXPECT_EQ(worst_of(0, 1, 60), ""); }
TEST_P(NearVertices, OneRoundingApartChangeNoDistance) { EXPECT_EQ(worst_of(2e-16, 101, 60), ""); }
TEST_P(NearVertices, SomeRoundingsApartChangeNoDistance) { EXPECT_EQ(worst_of(6e-15, 201, 60), ""); }
TEST_P(NearVertices, AtTheErrorOfPathsChangeDistancesByTheirGap) { EXPECT_EQ(worst_of(1e-13, 301, 60), ""); }
TEST_P(NearVertices, FartherApartChangeDistancesByTheirGap) {
  EXPECT_EQ(worst_of(1e-11, 401, 30), "");
  EXPECT_EQ(worst_of(1e-9, 501, 30), "");
  EXPECT_EQ(worst_of(1e-7, 601, 30), "");
}

INSTANTIATE_TEST_SUITE_P(Plugins, NearVertices, testing::Values("chen_han", "schreiber"));

}  // namespace
}  // namespace geodrome::test
