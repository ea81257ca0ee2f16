// SPDX-License-Identifier: MIT
// Meshes in which many faces meet at every edge, so that wavefronts multiply unless what came to an edge from one face
// is compared with what came from the others.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/plugins/solvers/exactness_fixture.hpp"

namespace geodrome::test {
namespace {

/// Faces at random among a few points, in space or in a plane; on a lattice of `steps` places a side many vertices lie
/// on edges and in one place, and many faces have no area.
MeshPtr tangle(std::size_t vertices, std::size_t faces, bool flat, std::size_t steps, std::uint64_t seed) {
  shapes::Random random(seed);
  const auto coordinate = [&] { return steps > 0 ? static_cast<double>(random.index(steps)) : random.uniform(); };
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double x = coordinate(), y = coordinate();
    positions.push_back({x, y, flat ? 0 : coordinate()});
  }
  std::vector<Triangle> triangles;
  const auto vertex = [&] { return static_cast<Index>(random.index(vertices)); };
  while (triangles.size() < faces) {
    const Index a = vertex(), b = vertex(), c = vertex();
    const auto same = [&](Index v, Index w) { return norm(positions[v] - positions[w]) == 0; };
    if (!same(a, b) && !same(b, c) && !same(c, a)) triangles.push_back({a, b, c});
  }
  return share(SurfaceMesh(std::move(positions), std::move(triangles)));
}

/// All triangles of some points.
MeshPtr complete(Index vertices, bool flat) {
  shapes::Random random(vertices);
  std::vector<Vec3> positions;
  for (Index i = 0; i < vertices; ++i) {
    const double x = random.uniform(), y = random.uniform();
    positions.push_back({x, y, flat ? 0 : random.uniform()});
  }
  std::vector<Triangle> triangles;
  for (Index a = 0; a < vertices; ++a)
    for (Index b = a + 1; b < vertices; ++b)
      for (Index c = b + 1; c < vertices; ++c) triangles.push_back({a, b, c});
  return share(SurfaceMesh(std::move(positions), std::move(triangles)));
}

/// Every face so many times.
MeshPtr repeated(const MeshPtr& mesh, int times) {
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh->triangles()) triangles.insert(triangles.end(), static_cast<std::size_t>(times), t);
  return share(SurfaceMesh({mesh->positions().begin(), mesh->positions().end()}, std::move(triangles)));
}

/// Triangles about the edge from (0, 0, 0) to (0, 0, 1), with their tips at distance 1 from it.
MeshPtr leaves(std::size_t count) {
  std::vector<Vec3> positions{{0, 0, 0}, {0, 0, 1}};
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    positions.push_back(
        {std::cos(turn), std::sin(turn), static_cast<double>(i * 7 % count) / static_cast<double>(count)});
    triangles.push_back({0, 1, static_cast<Index>(2 + i)});
  }
  return share(SurfaceMesh(std::move(positions), std::move(triangles)));
}

class Tangles : public testing::TestWithParam<std::string> {
 protected:
  const std::string& name() const { return GetParam(); }

  /// By the other exact solver, by the paths traced and by the audit.
  void expect_exact(const MeshPtr& mesh, const std::string& what) const {
    const Plugin<ShortestPathSolver> judged = load_solver(name());
    const Plugin<ShortestPathSolver> peer = load_solver(name() == "chen_han" ? "schreiber" : "chen_han");
    const bench::Exactness result = bench::judge(judged, &peer, mesh, {.sources = 6, .points = 60});
    EXPECT_TRUE(result.exact() && result.peer_silent.empty()) << name() << " on " << what << "\n"
                                                              << bench::exactness_names() << "\n"
                                                              << bench::exactness_figures(result) << "\n"
                                                              << bench::exactness_notes(result);
  }
};

TEST_P(Tangles, AreSolvedExactly) {
  for (const bool flat : {true, false})
    for (const auto& [vertices, faces] : {std::pair(8, 50), {12, 97}, {12, 200}, {30, 100}, {30, 400}})
      for (const std::uint64_t seed : {1, 2})
        expect_exact(tangle(vertices, faces, flat, 0, seed),
                     (flat ? "flat tangle " : "tangle ") + std::to_string(faces) + ":" + std::to_string(seed));
}

/// Paths too must end where several vertices lie in one place, inside edges of faces without area.
TEST_P(Tangles, OnALatticeAreSolvedExactly) {
  for (const bool flat : {true, false})
    for (const auto& [vertices, faces] : {std::pair(8, 25), {10, 40}, {12, 60}})
      for (std::uint64_t seed = 1; seed <= 12; ++seed)
        expect_exact(tangle(vertices, faces, flat, 4, seed),
                     (flat ? "flat lattice " : "lattice ") + std::to_string(faces) + ":" + std::to_string(seed));
}

TEST_P(Tangles, OfAllTrianglesOfSomePointsHaveStraightEdgesAsShortestPaths) {
  for (Index vertices = 6; vertices <= 12; ++vertices)
    for (const bool flat : {true, false}) {
      const MeshPtr mesh = complete(vertices, flat);
      for (const Index source : {Index{0}, vertices - 1}) {
        const std::vector<double> distances = from_vertex(load_solver(name()), mesh, source);
        for (Index v = 0; v < vertices; ++v)
          EXPECT_NEAR(distances[v], norm(mesh->positions()[v] - mesh->positions()[source]), 1e-15);
      }
      expect_exact(mesh, "all triangles of " + std::to_string(vertices) + " points");
    }
}

/// Two leaves unfold into a plane, where the path from tip to tip is straight if it crosses the common edge.
TEST_P(Tangles, OfTwoHundredLeavesAreSolvedAsUnfolded) {
  const MeshPtr mesh = leaves(200);
  for (const Index source : {2, 77, 201}) {
    const std::vector<double> distances = from_vertex(load_solver(name()), mesh, source);
    for (Index v = 2; v < mesh->vertex_count(); ++v) {
      const double rise = mesh->positions()[v].z - mesh->positions()[source].z;
      EXPECT_NEAR(distances[v], v == source ? 0 : std::hypot(2, rise), 1e-14);
    }
  }
  expect_exact(mesh, "leaves");
}

TEST_P(Tangles, OfEveryFaceManyTimesHaveTheDistancesOfTheFacesOnce) {
  const MeshPtr once = shape("jittered-torus", 500);
  const std::vector<double> expected = from_vertex(load_solver(name()), once, 0);
  for (const int times : {2, 3, 10}) {
    const std::vector<double> distances = from_vertex(load_solver(name()), repeated(once, times), 0);
    ASSERT_EQ(distances.size(), expected.size());
    for (std::size_t v = 0; v < expected.size(); ++v) EXPECT_NEAR(distances[v], expected[v], 1e-12 * expected[v]);
  }
  expect_exact(repeated(shape("plane", 100), 10), "a plane ten times");
}

INSTANTIATE_TEST_SUITE_P(Exact, Tangles, testing::Values("chen_han", "schreiber"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace geodrome::test
