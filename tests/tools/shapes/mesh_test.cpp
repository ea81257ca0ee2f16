// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "tests/support/shape_equations.hpp"
#include "tools/shapes/shapes.hpp"
#include "tools/shapes/sheets.hpp"

namespace geodrome {
namespace {

long euler_number(const SurfaceMesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) edges.insert(std::minmax({mesh.from(h), mesh.to(h)}));
  return static_cast<long>(mesh.vertex_count() + mesh.face_count()) - static_cast<long>(edges.size());
}

bool is_open(const std::string& kind) {
  return kind.starts_with("cut-") || std::ranges::count(shapes::sheet_kinds(), kind) > 0;
}

class ShapeMesh : public testing::TestWithParam<std::string> {
 protected:
  const std::string& kind() const { return GetParam(); }
};

TEST_P(ShapeMesh, IsAnOrientedManifoldOfItsTopology) {
  const std::map<std::string, long> expected{
      {"torus", 0},      {"jittered-torus", 0}, {"trefoil", 0},    {"genus2", -2}, {"genus5", -8},  {"plane", 1},
      {"cut-sphere", 1}, {"cut-torus", 0},      {"swiss-roll", 1}, {"s-curve", 1}, {"slit-pipe", 1}};
  for (const std::size_t faces : {40, 700, 9000}) {
    const SurfaceMesh mesh = shapes::mesh(kind(), faces);
    EXPECT_TRUE(mesh.manifold()) << faces;
    EXPECT_TRUE(mesh.oriented()) << faces;
    EXPECT_EQ(mesh.closed(), !is_open(kind())) << faces;
    EXPECT_EQ(euler_number(mesh), expected.contains(kind()) ? expected.at(kind()) : 2) << faces;
  }
}

TEST_P(ShapeMesh, HasAboutAsManyFacesAsAsked) {
  for (const std::size_t faces : {4000, 12000, 30000}) {
    const double count = static_cast<double>(shapes::mesh(kind(), faces).face_count());
    EXPECT_LE(count, 2.0 * static_cast<double>(faces));
    EXPECT_GE(count, 0.5 * static_cast<double>(faces));
  }
}

TEST_P(ShapeMesh, IsTheSameForTheSameArguments) {
  const SurfaceMesh first = shapes::mesh(kind(), 5000, 7), second = shapes::mesh(kind(), 5000, 7);
  EXPECT_TRUE(std::ranges::equal(first.positions(), second.positions()));
  EXPECT_TRUE(std::ranges::equal(first.triangles(), second.triangles()));
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ShapeMesh, testing::ValuesIn(shapes::mesh_kinds()), test_name);

class ClosedShapeMesh : public ShapeMesh {};

TEST_P(ClosedShapeMesh, EnclosesAPositiveVolume) {
  const SurfaceMesh mesh = shapes::mesh(kind(), 5000);
  double volume = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    volume += dot(p, cross(q, r)) / 6;
  }
  EXPECT_GT(volume, 0.2);
}

std::vector<std::string> closed_kinds() {
  std::vector<std::string> kinds = shapes::mesh_kinds();
  std::erase_if(kinds, is_open);
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ClosedShapeMesh, testing::ValuesIn(closed_kinds()), test_name);

class SmoothShapeMesh : public ShapeMesh {};

TEST_P(SmoothShapeMesh, HasItsVerticesOnTheShape) {
  const SurfaceMesh mesh = shapes::mesh(kind(), 3000);
  for (const Vec3& p : mesh.positions()) {
    ASSERT_LE(test::distance_off_shape(kind(), p), 1e-12);
    ASSERT_TRUE(test::within_borders(kind(), p));
  }
}

TEST_P(SmoothShapeMesh, HasEveryFaceTurnedOutwards) {
  const SurfaceMesh mesh = shapes::mesh(kind(), 5000);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    ASSERT_GT(dot(cross(q - p, r - p), test::shape_gradient(kind(), (p + q + r) / 3)), 0) << "face " << f;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SmoothShapeMesh, testing::ValuesIn(shapes::sample_kinds()), test_name);

TEST(IcosphereMesh, HasTheNearestPowerOfFour) {
  EXPECT_EQ(shapes::mesh("icosphere", 1).face_count(), 20U);
  EXPECT_EQ(shapes::mesh("icosphere", 159).face_count(), 80U);
  EXPECT_EQ(shapes::mesh("icosphere", 161).face_count(), 320U);
  EXPECT_EQ(shapes::mesh("icosphere", 82000).face_count(), 81920U);
}

TEST(IcosphereMesh, HasUnitVertices) {
  const SurfaceMesh mesh = shapes::mesh("icosphere", 5000);
  for (const Vec3& p : mesh.positions()) ASSERT_NEAR(norm(p), 1, 1e-15);
}

TEST(NoisySphereMesh, DependsOnTheSeed) {
  const SurfaceMesh first = shapes::mesh("noisy-sphere", 1000, 1), second = shapes::mesh("noisy-sphere", 1000, 2);
  EXPECT_FALSE(std::ranges::equal(first.positions(), second.positions()));
}

TEST(NoisySphereMesh, HasRadiiThatFillHalfAnEdgeOnBothSides) {
  constexpr double mean_edge = 0.1507;  // of the icosphere of 1280 faces
  double least = 2, most = 0;
  const SurfaceMesh mesh = shapes::mesh("noisy-sphere", 1280);
  for (const Vec3& p : mesh.positions()) {
    least = std::min(least, norm(p));
    most = std::max(most, norm(p));
  }
  EXPECT_NEAR(least, 1 - mean_edge / 2, 0.001);
  EXPECT_NEAR(most, 1 + mean_edge / 2, 0.001);
}

TEST(BumpyMesh, HasTheRadiusOfItsFormula) {
  const SurfaceMesh mesh = shapes::mesh("bumpy", 1000);
  for (const Vec3& p : mesh.positions()) {
    const Vec3 d = p / norm(p);
    const double radius = 1 + 0.25 * std::sin(3 * d.x + 1) * std::cos(2 * d.y) + 0.15 * std::sin(4 * d.x * d.z + 0.5);
    ASSERT_NEAR(norm(p), radius, 1e-13);
  }
}

TEST(JitteredTorusMesh, StaysOnTheTorusOffTheGrid) {
  const SurfaceMesh jittered = shapes::mesh("jittered-torus", 2000, 3), regular = shapes::mesh("torus", 2000);
  ASSERT_EQ(jittered.vertex_count(), regular.vertex_count());
  std::size_t moved = 0;
  for (Index v = 0; v < jittered.vertex_count(); ++v) {
    ASSERT_LE(test::distance_off_shape("torus", jittered.positions()[v]), 1e-12);
    moved += jittered.positions()[v] != regular.positions()[v];
  }
  EXPECT_EQ(moved, jittered.vertex_count());
}

TEST(ShapeMeshes, RefuseAnUnknownKindAndNameTheValidOnes) {
  try {
    shapes::mesh("cube", 100);
    FAIL() << "no error";
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find("jittered-torus"), std::string::npos);
  }
}

}  // namespace
}  // namespace geodrome
