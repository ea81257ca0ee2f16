// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "geodrome/vertex_components.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/hostile.hpp"
#include "tools/shapes/meshes.hpp"

namespace geodrome::shapes {
namespace {

constexpr double pi = std::numbers::pi;

bool same(const SurfaceMesh& a, const SurfaceMesh& b) {
  return std::ranges::equal(a.positions(), b.positions()) && std::ranges::equal(a.triangles(), b.triangles());
}

/// The sum of the angles at a vertex.
double total_angle(const SurfaceMesh& mesh, Index vertex) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (int i = 0; i < 3; ++i) {
      if (mesh.triangles()[f][i] != vertex) continue;
      const auto corners = mesh.corners(f);
      const Vec3 u = corners[(i + 1) % 3] - corners[i], v = corners[(i + 2) % 3] - corners[i];
      sum += std::atan2(norm(cross(u, v)), dot(u, v));
    }
  return sum;
}

double edge_ratio(const SurfaceMesh& mesh) {
  double least = INFINITY, most = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const double length = distance(mesh.positions()[mesh.from(h)], mesh.positions()[mesh.to(h)]);
    least = std::min(least, length), most = std::max(most, length);
  }
  return most / least;
}

TEST(HostileMeshes, AreOrientedManifoldsInOneComponentThatGrowWithTheirSize) {
  const std::set<std::string> closed_ones{"needle-cylinder", "cube", "flat-box", "octahedron", "pillow"};
  for (const HostileFamily& family : hostile_families()) {
    std::size_t faces = 0;
    for (const std::size_t size : {0, 1, 2}) {
      const SurfaceMesh mesh = family.make(size, 1);
      EXPECT_TRUE(mesh.manifold() && mesh.oriented()) << family.name << " " << size;
      EXPECT_EQ(mesh.closed(), closed_ones.contains(family.name)) << family.name;
      EXPECT_TRUE(std::ranges::all_of(vertex_components(mesh), [](Index c) { return c == 0; })) << family.name;
      EXPECT_GT(mesh.face_count(), faces) << family.name;
      faces = mesh.face_count();
    }
  }
}

TEST(HostileMeshes, AreTheSameForTheSameSeed) {
  for (const HostileFamily& family : hostile_families())
    EXPECT_TRUE(same(family.make(0, 5), family.make(0, 5))) << family.name;
  EXPECT_FALSE(same(hostile("terrain-5", 0, 1), hostile("terrain-5", 0, 2)));
}

TEST(HostileMeshes, RefuseAnUnknownNameAndSize) {
  EXPECT_THROW(hostile("swamp", 0), OptionError);
  EXPECT_THROW(hostile("cube", 3), OptionError);
}

TEST(Terrain, HasTheStandardSizeAndHeights) {
  const SurfaceMesh mesh = hostile("terrain-50", 2);
  EXPECT_EQ(mesh.vertex_count(), 81u * 81);
  const auto [low, high] = std::ranges::minmax(mesh.positions(), {}, &Vec3::z);
  EXPECT_GE(low.z, -50);
  EXPECT_LE(low.z, -49.5);
  EXPECT_LE(high.z, 50);
  EXPECT_GE(high.z, 49.5);
}

TEST(NeedleCone, HasAnApexOfItsDegreeThatIsConvexOrASaddle) {
  const SurfaceMesh cone = needle_cone(400, 0), saddle = needle_cone(400, 3);
  EXPECT_EQ(cone.face_count(), 400u * 19);
  EXPECT_EQ(std::ranges::count_if(cone.triangles(), [](const Triangle& t) { return std::ranges::count(t, 0u) > 0; }),
            400);
  EXPECT_LT(total_angle(cone, 0), 2 * pi - 0.1);
  EXPECT_GT(total_angle(saddle, 0), 2 * pi + 0.1);
  EXPECT_NEAR(norm(cone.positions().back()) / norm(cone.positions()[1]), std::pow(1.3, 9), 1e-9);
}

TEST(NeedleCylinder, HasTwoFlatVerticesOfHighDegree) {
  const SurfaceMesh mesh = needle_cylinder(64, 1);
  EXPECT_EQ(mesh.face_count(), 4u * 64);
  const auto middle = static_cast<Index>(mesh.vertex_count() - 1);
  EXPECT_NEAR(total_angle(mesh, middle), 2 * pi, 1e-12);
  EXPECT_NEAR(total_angle(mesh, middle - 1), 2 * pi, 1e-12);
}

TEST(StretchedAndGradedMeshes, HaveLongEdgesBesideShortOnes) {
  EXPECT_GT(edge_ratio(stretched_waves(24, 1000, 1)), 900);
  EXPECT_GT(edge_ratio(graded_grid(64, 1)), std::pow(1.25, 60));
}

TEST(Spirals, BendAtTheirInnerWall) {
  const SurfaceMesh corridor = spiral_corridor(4), stair = spiral_stair(6);
  EXPECT_GT(total_angle(corridor, 5 * 50), pi + 0.01);  // lane 0 of piece 50
  EXPECT_GT(total_angle(stair, 5 * 50), pi + 0.01);
}

TEST(NearFlat, MissesTheFullTurnByTheSquareOfItsHeights) {
  const SurfaceMesh mesh = near_flat(24, 0, 1);
  for (const Vec3& p : mesh.positions()) {
    ASSERT_GE(std::abs(p.z), 1e-7 * (1 - 1e-9));
    ASSERT_LE(std::abs(p.z), 1e-5 * (1 + 1e-9));
  }
  ASSERT_NEAR(total_angle(mesh, 12 * 25 + 12), 2 * pi, 1e-9);
}

TEST(CollapsedFaces, HaveNoAreaOnePerNinthVertex) {
  const SurfaceMesh mesh = collapsed_faces(13, 1);
  const auto is_collapsed = [&](const Triangle& t) {
    const Vec3 p = mesh.positions()[t[0]], q = mesh.positions()[t[1]], r = mesh.positions()[t[2]];
    return norm(cross(q - p, r - p)) < 1e-14;
  };
  EXPECT_EQ(std::ranges::count_if(mesh.triangles(), is_collapsed), 16);
}

TEST(LatticeBox, HasTheAreaOfItsSides) {
  EXPECT_NEAR(area(lattice_box(4, 5, 6)), 2.0 * (20 + 30 + 24), 1e-9);
  EXPECT_EQ(lattice_box(4, 5, 6).face_count(), 4u * (20 + 30 + 24));
}

TEST(Octahedron, HasEquilateralFaces) {
  EXPECT_EQ(octahedron(3).face_count(), 512u);
  EXPECT_NEAR(edge_ratio(octahedron(3)), 1, 1e-12);
}

TEST(Pillow, HasTwoFlatSheets) {
  const SurfaceMesh mesh = pillow(8);
  EXPECT_NEAR(area(mesh), 2 * 64, 1e-12);
  EXPECT_EQ(mesh.vertex_count(), 81u + 49);
  EXPECT_NEAR(total_angle(mesh, 0), pi, 1e-12);
}

TEST(FuzzMeshes, AreTheSameForTheSameSeed) {
  EXPECT_TRUE(same(fuzz_mesh(7).mesh, fuzz_mesh(7).mesh));
  EXPECT_EQ(fuzz_mesh(7).recipe, fuzz_mesh(7).recipe);
  EXPECT_FALSE(same(fuzz_mesh(7).mesh, fuzz_mesh(8).mesh));
}

TEST(FuzzMeshes, HaveAtMostTwoFacesAnEdgeOneEachWay) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const FuzzMesh fuzz = fuzz_mesh(seed);
    ASSERT_TRUE(fuzz.mesh.oriented()) << seed << " " << fuzz.recipe;
    ASSERT_GT(fuzz.mesh.face_count(), 0u) << seed << " " << fuzz.recipe;
    ASSERT_LT(fuzz.mesh.face_count(), 5000u) << seed << " " << fuzz.recipe;
  }
}

TEST(FuzzMeshes, AreOfAllSorts) {
  std::size_t manifold = 0, closed = 0, several = 0, tiny = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const SurfaceMesh mesh = fuzz_mesh(seed).mesh;
    const std::vector<Index> component = vertex_components(mesh);
    manifold += mesh.manifold(), closed += mesh.closed();
    several += std::set<Index>(component.begin(), component.end()).size() > 1;
    tiny += std::ranges::all_of(mesh.positions(), [](const Vec3& p) { return norm(p) < 0.1; });
  }
  EXPECT_GT(manifold, 150u);
  EXPECT_LT(manifold, 290u);
  EXPECT_GT(closed, 50u);
  EXPECT_LT(closed, 250u);
  EXPECT_GT(several, 20u);
  EXPECT_GT(tiny, 5u);
}

}  // namespace
}  // namespace geodrome::shapes
