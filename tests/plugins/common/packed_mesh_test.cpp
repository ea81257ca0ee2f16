// SPDX-License-Identifier: MIT
#include "geodrome/solver_kit/packed_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

/// A length or an angle is a handful of operations away from the coordinates.
constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

double angle(const PackedMesh::Face& face, int i) { return std::atan2(face.sine[i], face.cosine[i]); }

/// Closed, bordered, not manifold, not oriented.
std::vector<MeshPtr> every_sort() {
  return {cube(),    octahedron(), plane_grid(4), bumpy_torus(9, 6, 0.1, 1), terrain(6, 2, 2), fan(7, 1.1),
          bow_tie(), book(),       moebius(7),    both(cube(), book())};
}

/// Two triangles over the edge from (0, 0, 0) to (1, 0, 0); vertices 2 and 3 are `up` above and below its middle.
MeshPtr kite(double up) { return make({{0, 0, 0}, {1, 0, 0}, {0.5, up, 0}, {0.5, -up, 0}}, {{0, 1, 2}, {1, 0, 3}}); }

Vec3 end_of(const PackedMesh& flat, Index h, bool start) {
  return flat.mesh().positions()[flat.original_vertex(flat.from(start ? h : SurfaceMesh::next(h)))];
}

TEST(PackedMesh, LengthsAreThoseOfTheMeshTimesAPowerOfTwo) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    for (Index h = 0; h < 3 * flat.face_count(); ++h) {
      const double length = std::ldexp(distance(end_of(flat, h, true), end_of(flat, h, false)), flat.exponent());
      ASSERT_NEAR(flat.length(h), length, rounding * length);
    }
  }
}

TEST(PackedMesh, TheMeanEdgeIsAboutOneLong) {
  for (const double scale : {1e-9, 1e-3, 1.0, 7.0, 1e12}) {
    const PackedMesh flat(mapped(bumpy_torus(9, 6, 0.1, 1), [&](const Vec3& p) { return scale * p; }));
    double sum = 0;
    for (Index h = 0; h < 3 * flat.face_count(); ++h) sum += flat.length(h);
    const double mean = sum / static_cast<double>(3 * flat.face_count());
    EXPECT_GE(mean, 1 - 1e-9) << scale;  // 1 up to the rounding of the sum
    EXPECT_LT(mean, 2 + 1e-9) << scale;
  }
}

TEST(PackedMesh, AnglesOfAFaceSumToPi) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    for (Index f = 0; f < flat.face_count(); ++f) {
      const PackedMesh::Face& face = flat.face(f);
      ASSERT_NEAR(angle(face, 0) + angle(face, 1) + angle(face, 2), std::numbers::pi, rounding * std::numbers::pi);
    }
  }
}

TEST(PackedMesh, SinesAndCosinesAreThoseOfTheMesh) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    for (Index f = 0; f < flat.face_count(); ++f) {
      const auto p = mesh->corners(flat.original_face(f));
      for (int i = 0; i < 3; ++i) {
        const Vec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
        ASSERT_NEAR(flat.face(f).cosine[i], dot(a, b) / (norm(a) * norm(b)), rounding);
        ASSERT_NEAR(flat.face(f).sine[i], norm(cross(a, b)) / (norm(a) * norm(b)), rounding);
      }
    }
  }
}

TEST(PackedMesh, AnglesOfANeedleAreExactToTheirOwnSize) {
  const double up = 1e-9;
  const PackedMesh flat(kite(up));
  const PackedMesh::Face& face = flat.face(flat.face_of_original(0));
  EXPECT_NEAR(angle(face, 0), std::atan(up / 0.5), rounding * 2 * up);
  EXPECT_NEAR(std::numbers::pi - angle(face, 2), 2 * std::atan(up / 0.5), rounding * std::numbers::pi);
}

TEST(PackedMesh, TheApexIsAsFarFromBothEndsAsTheSidesAreLong) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    for (Index h = 0; h < 3 * flat.face_count(); ++h) {
      const PackedMesh::Face& face = flat.face_of(h);
      const int i = static_cast<int>(h % 3);
      const auto [x, y] = PackedMesh::apex(face, i);
      ASSERT_GT(y, 0);
      ASSERT_NEAR(std::hypot(x, y), face.length[(i + 2) % 3], rounding * face.length[(i + 2) % 3]);
      const double size = face.length[i] + face.length[(i + 2) % 3];
      ASSERT_NEAR(std::hypot(x - face.length[i], y), face.length[(i + 1) % 3], rounding * size);
    }
  }
}

TEST(PackedMesh, PlacesInTheFrameOfAHalfEdgeAreAsFarApartAsOnTheMesh) {
  const PackedMesh flat(bumpy_torus(9, 6, 0.1, 1));
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const SurfacePoint p = flat.inner(random_point(flat.mesh(), random));
    SurfacePoint q{p.face, {0.2, 0.3, 0.5}};
    const double apart = distance(flat.mesh().position(flat.original(p)), flat.mesh().position(flat.original(q)));
    for (Index h = 3 * p.face; h < 3 * p.face + 3; ++h) {
      const auto [px, py] = flat.in_frame(h, p.b);
      const auto [qx, qy] = flat.in_frame(h, q.b);
      ASSERT_NEAR(std::hypot(px - qx, py - qy), std::ldexp(apart, flat.exponent()), 4 * rounding);  // edges < 4 long
    }
  }
}

TEST(PackedMesh, NumbersOfFacesArePermuted) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    ASSERT_EQ(flat.face_count(), mesh->face_count());
    for (Index f = 0; f < mesh->face_count(); ++f) {
      ASSERT_LT(flat.original_face(f), mesh->face_count());
      ASSERT_EQ(flat.face_of_original(flat.original_face(f)), f);
    }
  }
}

TEST(PackedMesh, NumbersOfVerticesArePermutedThoseOnNoFaceToo) {
  std::vector<MeshPtr> meshes = every_sort();
  meshes.push_back(make({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}}, {{1, 2, 4}}));
  for (const MeshPtr& mesh : meshes) {
    const PackedMesh flat(mesh);
    ASSERT_EQ(flat.vertex_count(), mesh->vertex_count());
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      ASSERT_LT(flat.original_vertex(v), mesh->vertex_count());
      ASSERT_EQ(flat.vertex_of_original(flat.original_vertex(v)), v);
    }
  }
}

TEST(PackedMesh, CornersOfAFaceKeepTheirOrder) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    for (Index f = 0; f < flat.face_count(); ++f)
      for (Index i = 0; i < 3; ++i)
        ASSERT_EQ(flat.original_vertex(flat.from(3 * f + i)), mesh->triangles()[flat.original_face(f)][i]);
  }
}

/// Brute force: every other half-edge with the same two ends.
TEST(PackedMesh, AcrossAHalfEdgeIsEveryOtherOneOnItsEdge) {
  using Found = std::set<std::pair<Index, bool>>;
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    const auto end = [&](Index h) { return flat.from(SurfaceMesh::next(h)); };
    for (Index h = 0; h < 3 * flat.face_count(); ++h) {
      Found expected, seen;
      for (Index g = 0; g < 3 * flat.face_count(); ++g) {
        if (g == h) continue;
        if (flat.from(g) == flat.from(h) && end(g) == end(h)) expected.insert({g, true});
        if (flat.from(g) == end(h) && end(g) == flat.from(h)) expected.insert({g, false});
      }
      flat.for_each_across(h, [&](Index other, bool mirrored) { seen.insert({other, mirrored}); });
      ASSERT_EQ(seen, expected);
    }
  }
}

TEST(PackedMesh, TheSpineOfABookHasTwoOthersAcross) {
  const PackedMesh flat(book());
  int others = 0;
  flat.for_each_across(3 * flat.face_of_original(1), [&](Index, bool mirrored) { others += mirrored; });
  EXPECT_EQ(others, 2);
}

TEST(PackedMesh, AnEdgeIsAFanIfMoreThanTwoFacesMeetThere) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    for (Index h = 0; h < 3 * flat.face_count(); ++h) {
      int others = 0;
      flat.for_each_across(h, [&](Index, bool) { ++others; });
      ASSERT_EQ(flat.is_fan(h), others > 1);
    }
  }
}

TEST(PackedMesh, AMoebiusStripIsMirroredAcrossOneEdge) {
  const PackedMesh flat(moebius(7));
  int mirrored_ones = 0;
  for (Index h = 0; h < 3 * flat.face_count(); ++h)
    flat.for_each_across(h, [&](Index, bool mirrored) { mirrored_ones += mirrored; });
  EXPECT_EQ(mirrored_ones, 2);  // from both sides
}

/// The same position to rounding, on every face of the edge once.
TEST(PackedMesh, APointOfAnEdgeHasANameOnEachOfItsFaces) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    for (Index h = 0; h < 3 * flat.face_count(); ++h) {
      SurfacePoint point{h / 3, {}};
      point.b[h % 3] = 0.3, point.b[(h + 1) % 3] = 0.7;
      std::multiset<Index> faces, expected{h / 3};
      flat.for_each_across(h, [&](Index other, bool) { expected.insert(other / 3); });
      flat.for_each_name(point, [&](const SurfacePoint& name) {
        faces.insert(name.face);
        ASSERT_EQ(mesh->position(flat.original(name)), mesh->position(flat.original(point)));
      });
      ASSERT_EQ(faces, expected);
    }
  }
}

TEST(PackedMesh, APointInAFaceHasOneName) {
  const PackedMesh flat(cube());
  int names = 0;
  flat.for_each_name({3, {0.2, 0.3, 0.5}}, [&](const SurfacePoint& name) {
    ++names;
    EXPECT_EQ(name, (SurfacePoint{3, {0.2, 0.3, 0.5}}));
  });
  EXPECT_EQ(names, 1);
}

TEST(PackedMesh, EveryCornerIsListedAtItsVertex) {
  for (const MeshPtr& mesh : every_sort()) {
    const PackedMesh flat(mesh);
    std::multiset<Index> listed;
    for (Index v = 0; v < flat.vertex_count(); ++v)
      for (const Index h : flat.corners(v)) {
        ASSERT_EQ(flat.from(h), v);
        listed.insert(h);
      }
    ASSERT_EQ(listed.size(), 3 * flat.face_count());
    for (Index h = 0; h < 3 * flat.face_count(); ++h) ASSERT_EQ(listed.count(h), 1U);
  }
}

/// Counterclockwise the edge at the end of one face's corner is that at the start of the next one's.
TEST(PackedMesh, CornersAroundAVertexFollowEachOther) {
  for (const MeshPtr& mesh : {cube(), plane_grid(4), bumpy_torus(9, 6, 0.1, 1), terrain(6, 2, 2), fan(7, 1.1)}) {
    const PackedMesh flat(mesh);
    for (Index v = 0; v < flat.vertex_count(); ++v) {
      const auto corners = flat.corners(v);
      const bool open = flat.face_of(corners[0]).across[corners[0] % 3] == no_index;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Index last = SurfaceMesh::previous(corners[i]);
        if (open && i + 1 == corners.size()) {
          ASSERT_EQ(flat.face_of(last).across[last % 3], no_index);
          continue;
        }
        Index next = no_index;
        flat.for_each_across(last, [&](Index other, bool) { next = other; });
        ASSERT_EQ(next, corners[(i + 1) % corners.size()]);
      }
    }
  }
}

}  // namespace
}  // namespace geodrome::test
