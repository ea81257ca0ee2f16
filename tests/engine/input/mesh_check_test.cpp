// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <random>

#include "geodrome/surface.hpp"
#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

const std::filesystem::path meshes = std::filesystem::path(GEODROME_SHARED_DATA) / "meshes";

std::string off(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  std::string text = "OFF\n" + std::to_string(points.size()) + " " + std::to_string(triangles.size()) + " 0\n";
  for (const Vec3& p : points)
    text += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  for (const Triangle& t : triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return text;
}

// An n x m lattice of quads, each cut in two; its sides glued as asked, a glued one with a twist if `twisted`.
std::vector<Triangle> lattice(Index n, Index m, bool glue_columns, bool glue_rows, bool twisted) {
  const Index columns = glue_columns ? n : n + 1, rows = glue_rows ? m : m + 1;
  const auto vertex = [&](Index i, Index j) {
    const bool around = glue_columns && i == n;
    if (around && twisted) j = m - j;
    return (around ? 0 : i) + columns * (glue_rows ? j % rows : j);
  };
  std::vector<Triangle> triangles;
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return triangles;
}

InputFacts facts_of(const std::vector<Triangle>& triangles) {
  Index count = 0;
  for (const Triangle& t : triangles) count = std::max({count, t[0] + 1, t[1] + 1, t[2] + 1});
  std::vector<Vec3> points;
  for (Index v = 0; v < count; ++v) points.push_back({double(v), double(v * v % 17), double(v * v % 13)});
  return read_bytes("m.off", off(points, triangles)).facts;
}

TEST(InputMeshCheck, ADiscHasOneLoopAndGenusZero) {
  const InputFacts facts = facts_of(lattice(5, 4, false, false, false));
  EXPECT_EQ(facts.euler_number, 1);
  EXPECT_EQ(facts.boundary_loops, 1u);
  EXPECT_EQ(facts.boundary_edges, 18u);
  EXPECT_EQ(facts.genus, 0);
}

TEST(InputMeshCheck, ATubeHasTwoLoops) {
  const InputFacts facts = facts_of(lattice(5, 4, true, false, false));
  EXPECT_EQ(facts.euler_number, 0);
  EXPECT_EQ(facts.boundary_loops, 2u);
  EXPECT_EQ(facts.genus, 0);
}

TEST(InputMeshCheck, ATorusHasGenusOne) {
  const InputFacts facts = facts_of(lattice(5, 4, true, true, false));
  EXPECT_EQ(facts.euler_number, 0);
  EXPECT_EQ(facts.boundary_edges, 0u);
  EXPECT_EQ(facts.genus, 1);
}

TEST(InputMeshCheck, AKleinBottleIsClosedAndNotOrientable) {
  const InputFacts facts = facts_of(lattice(6, 5, true, true, true));
  EXPECT_TRUE(facts.manifold);
  EXPECT_EQ(facts.boundary_edges, 0u);
  EXPECT_FALSE(facts.oriented);
  EXPECT_FALSE(facts.orientable);
  EXPECT_FALSE(facts.genus);
}

TEST(InputMeshCheck, FactsDoNotDependOnHowFacesAreTurnedAndOrdered) {
  const std::vector<Triangle> torus = lattice(7, 5, true, true, false);
  std::mt19937_64 random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<Triangle> shuffled = torus;
    for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random() % i]);
    for (Triangle& t : shuffled) {
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
      if (random() % 2) std::swap(t[0], t[1]);
    }
    const InputFacts facts = facts_of(shuffled);
    EXPECT_TRUE(facts.manifold);
    EXPECT_FALSE(facts.oriented);
    EXPECT_TRUE(facts.orientable);
    EXPECT_EQ(facts.genus, 1);
  }
}

TEST(InputMeshCheck, ManifoldAndOrientedAgreeWithTheSurfaceMesh) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 300; ++round) {
    std::vector<Vec3> points;
    for (Index v = 0; v < 7; ++v) points.push_back({double(v), double(v * v), double(v * v * v)});
    std::vector<Triangle> triangles;
    for (std::uint64_t f = 2 + random() % 7; f > 0; --f) {
      std::vector<Index> order(points.size());
      std::iota(order.begin(), order.end(), Index{0});
      for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
      triangles.push_back({order[0], order[1], order[2]});
    }
    const Input input = read_bytes("m.off", off(points, triangles));
    const SurfaceMesh mesh(input.positions, input.triangles);
    EXPECT_EQ(input.facts.manifold, mesh.manifold());
    EXPECT_EQ(input.facts.oriented, mesh.oriented());
    EXPECT_EQ(input.facts.boundary_edges == 0, mesh.closed());
  }
}

TEST(InputMeshCheck, WeldingDropsFacesThatCollapse) {
  const Input input =
      read_bytes("m.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-0 0 0\n5 5 5\n3 0 1 2\n3 0 3 1\n", {.weld = true});
  EXPECT_EQ(input.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(input.element_of_row, (std::vector<Index>{0, 1, 2, 0, 3}));
  EXPECT_EQ(input.facts.merged, 1u);
  EXPECT_EQ(input.facts.degenerate_faces_dropped, 1u);
  EXPECT_TRUE(has_finding(input, "welded_vertices"));
}

TEST(InputMeshCheck, WithoutWeldingEqualPlacesAreToldAndStay) {
  const Input input = read_bytes("m.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n3 1 2 3\n");
  EXPECT_EQ(input.positions.size(), 4u);
  EXPECT_EQ(input.facts.duplicate_positions, 1u);
  EXPECT_EQ(input.facts.isolated_vertices, 1u);
  const auto told = std::ranges::find(input.findings, "duplicate_positions", &Finding::code);
  ASSERT_NE(told, input.findings.end());
  EXPECT_EQ(told->remedy.code, "read.weld");
}

TEST(InputMeshCheck, ZeroAreaIsJudgedAtEveryScale) {
  for (const char* scale : {"e-90", "", "e90"}) {
    const std::string one = std::string("1") + scale;
    const std::string points = "0 0 0\n" + one + " 0 0\n2" + scale + " 0 0\n0 " + one + " 0\n";
    EXPECT_EQ(read_bytes("m.off", "OFF\n4 2 0\n" + points + "3 0 1 2\n3 0 1 3\n").facts.zero_area_faces, 1u) << one;
  }
}

TEST(InputMeshCheck, AMeshOfNothingButDegenerateFacesIsRefused) {
  expect_refused([] { read_bytes("m.off", "OFF\n2 1 0\n0 0 0\n1 0 0\n3 0 1 1\n"); }, InputFault::degenerate, "m.off");
}

TEST(InputMeshCheck, FindingsNameAtMostTenElements) {
  std::string text = "OFF\n40 1 0\n";
  for (int i = 0; i < 40; ++i) text += std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
  const Input input = read_bytes("m.off", text + "3 0 1 2\n");
  ASSERT_TRUE(has_finding(input, "isolated_vertices"));
  EXPECT_EQ(input.findings[0].count, 37u);
  EXPECT_EQ(input.findings[0].elements, (std::vector<Index>{3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

// What is published about real meshes.
struct Published {
  const char* file;
  std::size_t rows, faces, components, loops;
  std::optional<long> genus;
};

TEST(InputMeshCheck, RealMeshesHaveTheirPublishedFacts) {
  if (!std::filesystem::exists(meshes)) GTEST_SKIP() << "no folder " << meshes;
  const Published all[] = {{"fish_low.obj", 945, 1886, 1, 0, 0},
                           {"cheese.off", 8629, 17786, 1, 0, 133},
                           {"plane_holes.obj", 8519, 16747, 1, 27, 0},
                           {"mountain.ply", 25600, 50562, 1, 1, 0},
                           {"tray_bottom.stl", 2216, 4520, 1, 0, 23},
                           {"fish_low_binary.stl", 945, 1886, 1, 0, 0},
                           {"turbineblade.ply", 99519, 199034, 1, 0, 0},
                           {"human_man.ply", 6890, 13776, 1, 0, 0},
                           {"cycloidal_defects.ply", 21384, 43368, 100, 0, std::nullopt}};
  for (const Published& published : all) {
    const InputFacts facts = read_input(meshes / published.file).facts;
    EXPECT_EQ(facts.rows, published.rows) << published.file;
    EXPECT_EQ(facts.faces_in_file, published.faces) << published.file;
    EXPECT_EQ(facts.components, published.components) << published.file;
    EXPECT_EQ(facts.boundary_loops, published.loops) << published.file;
    EXPECT_EQ(facts.genus, published.genus) << published.file;
  }
}

TEST(InputMeshCheck, RealDefectsHaveTheirPublishedCounts) {
  if (!std::filesystem::exists(meshes)) GTEST_SKIP() << "no folder " << meshes;
  const InputFacts facts = read_input(meshes / "cycloidal_defects.ply").facts;
  EXPECT_EQ(facts.nonmanifold_edges, 242u);
  EXPECT_EQ(facts.nonmanifold_vertices, 26u);
}

}  // namespace
}  // namespace geodrome::testing
