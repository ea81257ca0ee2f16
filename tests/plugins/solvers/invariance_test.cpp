// SPDX-License-Identifier: MIT
#include <numbers>
#include <numeric>

#include "tests/plugins/solvers/fixture.hpp"

namespace geodrome::test {
namespace {

constexpr std::uint64_t seeds = 4;

TEST_P(EverySolver, GivesTheSameAfterARigidMotion) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const MeshPtr& mesh : random_meshes(seed)) {
      shapes::Random random(seed);
      const double a = random.uniform(0, 2 * std::numbers::pi), b = random.uniform(0, 2 * std::numbers::pi);
      const MeshPtr other = moved(mesh, [&](const Vec3& p) {
        const Vec3 q{std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y, p.z};
        return Vec3{q.x + 3, std::cos(b) * q.y - std::sin(b) * q.z - 5, std::sin(b) * q.y + std::cos(b) * q.z + 2};
      });
      const Index source = random_vertex(mesh, random);
      EXPECT_LE(worst_difference(from_vertex(solver_, mesh, source), from_vertex(solver_, other, source)), rounding);
    }
}

TEST_P(EverySolver, ScalesWithTheMesh) {
  for (const double scale : {1e-6, 0.37, 1e6})
    for (const MeshPtr& mesh : random_meshes(7)) {
      shapes::Random random(11);
      const MeshPtr other = moved(mesh, [&](const Vec3& p) { return scale * p; });
      const Index source = random_vertex(mesh, random);
      std::vector<double> expected = from_vertex(solver_, mesh, source);
      for (double& d : expected) d *= scale;
      EXPECT_LE(worst_difference(expected, from_vertex(solver_, other, source)), rounding) << scale;
    }
}

/// A random order of 0 ... count - 1 (Fisher and Yates).
std::vector<Index> shuffled(std::size_t count, shapes::Random& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.index(i)]);
  return order;
}

TEST_P(EverySolver, DoesNotDependOnTheNumberingOfVerticesAndFaces) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const MeshPtr& mesh : random_meshes(seed)) {
      shapes::Random random(seed + 100);
      const std::vector<Index> new_vertex = shuffled(mesh->vertex_count(), random);
      const std::vector<Index> old_face = shuffled(mesh->face_count(), random);
      std::vector<Vec3> positions(mesh->vertex_count());
      for (Index v = 0; v < positions.size(); ++v) positions[new_vertex[v]] = mesh->positions()[v];
      std::vector<Triangle> triangles;
      for (const Index f : old_face) {
        const Triangle& t = mesh->triangles()[f];
        const std::size_t turn = random.index(3);
        triangles.push_back({new_vertex[t[turn]], new_vertex[t[(turn + 1) % 3]], new_vertex[t[(turn + 2) % 3]]});
      }
      const MeshPtr other = share(SurfaceMesh(positions, triangles));
      const Index source = random_vertex(mesh, random);
      const std::vector<double> expected = from_vertex(solver_, mesh, source);
      const std::vector<double> seen = from_vertex(solver_, other, new_vertex[source]);
      std::vector<double> back(seen.size());
      for (Index v = 0; v < back.size(); ++v) back[v] = seen[new_vertex[v]];
      EXPECT_LE(worst_difference(expected, back), rounding);
    }
}

TEST_P(EverySolver, IsAMetric) {
  constexpr std::size_t chosen = 6;
  for (const MeshPtr& mesh : random_meshes(3)) {
    shapes::Random random(5);
    std::vector<Index> vertex;
    std::vector<std::vector<double>> row;
    for (std::size_t i = 0; i < chosen; ++i) {
      vertex.push_back(random_vertex(mesh, random));
      row.push_back(from_vertex(solver_, mesh, vertex[i]));
    }
    const double slack = rounding * *std::max_element(row[0].begin(), row[0].end());
    for (std::size_t i = 0; i < chosen; ++i) {
      EXPECT_EQ(row[i][vertex[i]], 0);
      for (std::size_t j = 0; j < chosen; ++j) {
        EXPECT_NEAR(row[i][vertex[j]], row[j][vertex[i]], slack);
        for (Index v = 0; v < mesh->vertex_count(); ++v) ASSERT_LE(row[i][v], row[i][vertex[j]] + row[j][v] + slack);
      }
    }
  }
}

TEST_P(EverySolver, IsNeverShorterThanTheStraightLine) {
  for (const MeshPtr& mesh : random_meshes(13)) {
    const std::vector<double> d = from_vertex(solver_, mesh, 0);
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      ASSERT_GE(d[v], (1 - rounding) * distance(mesh->positions()[0], mesh->positions()[v]));
  }
}

TEST(SolverEdgeDijkstra, IsNeverShorterThanCgal) {
  const auto along_edges = load_solver("edge_dijkstra"), exact = load_solver("cgal");
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const MeshPtr& mesh : random_meshes(seed)) {
      shapes::Random random(seed + 50);
      const Index source = random_vertex(mesh, random);
      const std::vector<double> upper = from_vertex(along_edges, mesh, source);
      const std::vector<double> lower = from_vertex(exact, mesh, source);
      for (Index v = 0; v < mesh->vertex_count(); ++v) ASSERT_GE(upper[v], (1 - rounding) * lower[v]) << v;
    }
}

INSTANTIATE_TEST_SUITE_P(Plugins, EverySolver, testing::ValuesIn(every_solver()), solver_name);

}  // namespace
}  // namespace geodrome::test
