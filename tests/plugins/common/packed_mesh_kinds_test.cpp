// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome {

std::ostream& operator<<(std::ostream& out, PackedMesh::VertexKind kind) {
  constexpr const char* names[] = {"smooth", "saddle", "open_saddle", "irregular"};
  return out << names[static_cast<int>(kind)];
}

namespace test {
namespace {

using Kind = PackedMesh::VertexKind;

/// By the numbers of the mesh.
std::vector<Kind> kinds(const MeshPtr& mesh) {
  const PackedMesh flat(mesh);
  std::vector<Kind> result;
  for (Index v = 0; v < mesh->vertex_count(); ++v) result.push_back(flat.kind(flat.vertex_of_original(v)));
  return result;
}

MeshPtr scaled(const MeshPtr& mesh, double scale) {
  return mapped(mesh, [=](const Vec3& p) { return scale * p; });
}

/// The L of three unit squares, bent around vertex 0 at the origin.
MeshPtr corner_of_a_room() {
  return make({{0, 0, 0}, {0, -1, 0}, {1, -1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}},
              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}});
}

TEST(PackedMeshKinds, TheTipOfAConeIsSmooth) { EXPECT_EQ(kinds(fan(5, 1))[0], Kind::smooth); }

TEST(PackedMeshKinds, TheCornersOfACubeAreSmooth) { EXPECT_EQ(kinds(cube()), std::vector<Kind>(8, Kind::smooth)); }

TEST(PackedMeshKinds, AFanOfMoreThanAFullTurnHasASaddle) { EXPECT_EQ(kinds(fan(8, 0.9))[0], Kind::saddle); }

/// A grid of whole numbers, and turned so that no coordinate is.
TEST(PackedMeshKinds, EveryVertexOfARectangleIsSmooth) {
  for (const bool crossed : {false, true}) {
    const MeshPtr grid = plane_grid(6, crossed);
    EXPECT_EQ(kinds(grid), std::vector<Kind>(49, Kind::smooth));
    const Vec3 x{2 / 3.0, 2 / 3.0, 1 / 3.0}, y{-2 / 3.0, 1 / 3.0, 2 / 3.0};
    const MeshPtr turned = mapped(grid, [&](const Vec3& p) { return (0.1 * p.x) * x + (0.7 * p.y) * y; });
    EXPECT_EQ(kinds(turned), std::vector<Kind>(49, Kind::smooth));
  }
}

TEST(PackedMeshKinds, AReflexCornerOfTheBoundaryIsAnOpenSaddle) {
  EXPECT_EQ(kinds(corner_of_a_room())[0], Kind::open_saddle);
}

TEST(PackedMeshKinds, StraightAndConvexPlacesOfTheBoundaryAreSmooth) {
  const std::vector<Kind> seen = kinds(corner_of_a_room());
  for (Index v = 1; v < seen.size(); ++v) EXPECT_EQ(seen[v], Kind::smooth) << v;
}

TEST(PackedMeshKinds, AVertexOfTwoFansIsIrregularAndItsNeighboursAreNot) {
  const std::vector<Kind> seen = kinds(bow_tie());
  EXPECT_EQ(seen[0], Kind::irregular);
  for (Index v = 1; v < 5; ++v) EXPECT_EQ(seen[v], Kind::smooth) << v;
}

TEST(PackedMeshKinds, TheEndsOfAnEdgeWithThreeFacesAreIrregular) {
  const std::vector<Kind> seen = kinds(book());
  EXPECT_EQ(seen[0], Kind::irregular);
  EXPECT_EQ(seen[1], Kind::irregular);
  for (Index v = 2; v < 5; ++v) EXPECT_EQ(seen[v], Kind::smooth) << v;
}

TEST(PackedMeshKinds, TheEndsOfAMirroredEdgeAreIrregularAndNoOthers) {
  const std::vector<Kind> seen = kinds(moebius(9));
  for (Index v = 0; v < seen.size(); ++v) EXPECT_EQ(seen[v] == Kind::irregular, v < 2) << v;
}

/// Beside an edge with three faces, faces elsewhere are connected by the same table: they stay as they were.
TEST(PackedMeshKinds, AnEdgeWithThreeFacesElsewhereChangesNothing) {
  const MeshPtr torus = bumpy_torus(9, 6, 0.1, 1);
  std::vector<Kind> alone = kinds(torus), beside = kinds(both(torus, book()));
  beside.resize(alone.size());
  EXPECT_EQ(beside, alone);
}

TEST(PackedMeshKinds, AVertexOnNoFaceIsIrregular) {
  EXPECT_EQ(kinds(make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}}))[3], Kind::irregular);
}

/// A square with its middle, and a second vertex beside the middle.
MeshPtr square_with_two_middles(double apart) {
  return make({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}, {apart, 0, 0}},
              {{0, 1, 4}, {1, 2, 5}, {1, 5, 4}, {2, 3, 5}, {3, 0, 4}, {3, 4, 5}});
}

/// At 1e-12 of the box its direction is all but rounding.
TEST(PackedMeshKinds, TheEndsOfAnEdgeWithoutLengthOrWithHardlyAnyAreIrregularAndNoOthers) {
  for (const double apart : {0.0, 1e-12})
    EXPECT_EQ(
        kinds(square_with_two_middles(apart)),
        (std::vector<Kind>{Kind::smooth, Kind::smooth, Kind::smooth, Kind::smooth, Kind::irregular, Kind::irregular}))
        << apart;
}

TEST(PackedMeshKinds, TheEndsOfAShortEdgeAreJudgedByTheirAngles) {
  EXPECT_EQ(kinds(square_with_two_middles(1e-6)), std::vector<Kind>(6, Kind::smooth));
}

/// A face of two right angles and none opposite to the edge without length.
TEST(PackedMeshKinds, AFaceWithAnEdgeWithoutLengthIsASegment) {
  const PackedMesh flat(make({{0, 0, 0}, {0, 0, 0}, {3, 4, 0}}, {{0, 1, 2}}));
  const PackedMesh::Face& face = flat.face(0);
  EXPECT_EQ(face.length[0], 0);
  EXPECT_EQ(face.length[1], face.length[2]);
  for (const int i : {0, 1}) {
    EXPECT_EQ(face.cosine[i], 0) << i;
    EXPECT_EQ(face.sine[i], 1) << i;
  }
  EXPECT_EQ(face.cosine[2], 1);
  EXPECT_EQ(face.sine[2], 0);
}

/// Scaling rounds coordinates, which turns directions by an epsilon; no vertex of these is that near to flat.
TEST(PackedMeshKinds, DoNotDependOnTheUnitOfLength) {
  for (const MeshPtr& mesh :
       {bumpy_torus(12, 8, 0.1, 1), terrain(6, 2, 2), fan(8, 0.9), cube(), corner_of_a_room(), book(), moebius(7)})
    for (const double scale : {1e-6, 1e6, 1e-30, 1e30}) EXPECT_EQ(kinds(scaled(mesh, scale)), kinds(mesh)) << scale;
}

TEST(PackedMeshKinds, TheTestsHaveSaddlesOfBothKinds) {
  const std::vector<Kind> torus = kinds(bumpy_torus(12, 8, 0.1, 1)), hills = kinds(terrain(6, 2, 2));
  EXPECT_GT(std::count(torus.begin(), torus.end(), Kind::saddle), 5);
  EXPECT_GT(std::count(hills.begin(), hills.end(), Kind::open_saddle), 3);
}

/// Scaled by 10^+-6 angles are the same up to the rounding of coordinates; by a power of two to the last bit.
TEST(PackedMeshKinds, AnglesDoNotDependOnTheUnitOfLength) {
  const MeshPtr mesh = terrain(6, 2, 2);
  const PackedMesh flat(mesh);
  for (const double scale : {1e-6, 1e6, 0x1p-40, 0x1p40}) {
    const bool exact = scale == 0x1p-40 || scale == 0x1p40;
    const PackedMesh other(scaled(mesh, scale));
    for (Index f = 0; f < flat.face_count(); ++f)
      for (int i = 0; i < 3; ++i) {
        const PackedMesh::Face& a = flat.face(flat.face_of_original(f));
        const PackedMesh::Face& b = other.face(other.face_of_original(f));
        const double error = exact ? 0 : 40 * std::numeric_limits<double>::epsilon();  // coordinates are up to 6 edges
        ASSERT_NEAR(a.cosine[i], b.cosine[i], error) << scale;
        ASSERT_NEAR(a.sine[i], b.sine[i], error) << scale;
      }
  }
}

}  // namespace
}  // namespace test
}  // namespace geodrome
