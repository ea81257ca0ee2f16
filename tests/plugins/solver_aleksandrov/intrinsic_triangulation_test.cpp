// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/intrinsic/triangulation.hpp"

#include "tests/plugins/solver_aleksandrov/intrinsic_fixture.hpp"

namespace geodrome::aleksandrov::test {
namespace {

/// Rounding of a few hundred changes, each of which lays out four points again; lengths are about 1.
constexpr double rounding = 1e-11;

/// Calls `check(flat surface, triangulation before, triangulation after)` for random changes of each mesh.
template <class Check>
void for_each_change(const std::vector<NamedMesh>& meshes, std::uint64_t seed, Check&& check) {
  Random random(seed);
  for (const auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    const PackedMesh surface(mesh);
    const IntrinsicTriangulation before(surface, tiny);
    IntrinsicTriangulation after = before;
    change_often(after, 150, random);
    ASSERT_GT(after.vertex_count(), before.vertex_count());
    check(surface, before, after);
  }
}

TEST(IntrinsicTriangulation, HalfEdgesOfAnEdgeAreARingThatAgreesOnItsEnds) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for_each_change(all_meshes(seed), seed, [](auto&, auto&, const IntrinsicTriangulation& t) {
      for (Index h = 0; h < 3 * t.face_count(); ++h) {
        Index g = h;
        int steps = 0;
        do {
          const Index end = t.from(SurfaceMesh::next(g));
          ASSERT_EQ(t.from(h), t.same_way(g, h) ? t.from(g) : end) << h << " " << g;
          ASSERT_EQ(t.from(SurfaceMesh::next(h)), t.same_way(g, h) ? end : t.from(g)) << h << " " << g;
          g = t.next_on_edge(g);
          ASSERT_LT(++steps, 100) << "the ring of " << h << " does not close";
        } while (g != h);
      }
    });
}

TEST(IntrinsicTriangulation, BothSidesOfAnEdgeAreEquallyLongToTheLastBit) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for_each_change(fair_meshes(seed), seed, [](auto&, auto&, const IntrinsicTriangulation& t) {
      for (Index h = 0; h < 3 * t.face_count(); ++h) ASSERT_EQ(t.length(h), t.length(t.next_on_edge(h))) << h;
    });
}

TEST(IntrinsicTriangulation, AnglesFitTheLengths) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for_each_change(fair_meshes(seed), seed, [](auto&, auto&, const IntrinsicTriangulation& t) {
      for (Index h = 0; h < 3 * t.face_count(); ++h) {
        const Point2 end{t.length(h), 0}, apex = t.apex(h);
        const double size = std::max(t.length(h), length(apex));
        ASSERT_NEAR(length(apex - end), t.length(SurfaceMesh::next(h)), rounding * size) << h;
        ASSERT_GT(apex.y, 0) << h;
        const auto& face = t.face(h / 3);
        ASSERT_NEAR(face.cosine[h % 3] * face.cosine[h % 3] + face.sine[h % 3] * face.sine[h % 3], 1, 1e-14) << h;
      }
    });
}

/// Angles at a vertex, areas and handles are what the surface has, not what its triangulation is.
TEST(IntrinsicTriangulation, TheSurfaceStaysWhatItIs) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for_each_change(fair_meshes(seed), seed,
                    [](auto& surface, const IntrinsicTriangulation& before, const IntrinsicTriangulation& after) {
                      const auto was = total_angles(before, surface.vertex_count());
                      const auto is = total_angles(after, surface.vertex_count());
                      for (std::size_t v = 0; v < was.size(); ++v) ASSERT_NEAR(is[v], was[v], 1e-9) << v;
                      ASSERT_NEAR(area(after), area(before), rounding * area(before));
                      ASSERT_EQ(euler_number(after), euler_number(before));
                    });
}

TEST(IntrinsicTriangulation, VerticesPutIntoFacesAreFlat) {
  Random random(5);
  for (const auto& [name, mesh] : fair_meshes(5)) {
    const PackedMesh surface(mesh);
    IntrinsicTriangulation t(surface, tiny);
    for (int i = 0; i < 20; ++i) {
      const Index h = static_cast<Index>(random.index(3 * t.face_count()));
      const Index m = t.split_face(h, 0.3 * Point2{t.length(h), 0} + 0.4 * t.apex(h));
      ASSERT_NEAR(total_angles(t, m + 1)[m], 2 * std::numbers::pi, 1e-12) << name;
    }
  }
}

/// Half a turn for each of its faces.
TEST(IntrinsicTriangulation, VerticesPutOnEdgesHaveHalfATurnAFace) {
  Random random(6);
  for (const auto& [name, mesh] : fair_meshes(6)) {
    const PackedMesh surface(mesh);
    IntrinsicTriangulation t(surface, tiny);
    for (int i = 0; i < 20; ++i) {
      const Index h = static_cast<Index>(random.index(3 * t.face_count()));
      int faces = 1;
      for (Index g = t.next_on_edge(h); g != h; g = t.next_on_edge(g)) ++faces;
      const Index m = t.split_edge(h, 0.4 * t.length(h));
      ASSERT_NE(m, no_index) << name;
      ASSERT_NEAR(total_angles(t, m + 1)[m], faces * std::numbers::pi, 1e-12) << name;
    }
  }
}

TEST(IntrinsicTriangulation, OnlyEdgesThatTwoFacesOrientedAlikeShareAreFlat) {
  const PackedMesh book(geodrome::test::book());
  const IntrinsicTriangulation three(book, tiny);
  for (Index h = 0; h < 9; ++h) EXPECT_EQ(three.flat_twin(h), no_index) << h;
  const PackedMesh strip(geodrome::test::moebius(5));
  const IntrinsicTriangulation one_sided(strip, tiny);
  int flat = 0, mirrored = 0;
  for (Index h = 0; h < 3 * one_sided.face_count(); ++h) {
    const Index g = one_sided.next_on_edge(h);
    flat += one_sided.flat_twin(h) != no_index;
    mirrored += g != h && one_sided.same_way(g, h);
  }
  EXPECT_EQ(flat, 18);     // half-edges of the nine edges between faces that
  EXPECT_EQ(mirrored, 2);  // are not the one where the strip closes
}

/// The height is rounding: it must not take a place along the triangle.
TEST(Barycentric, NameThePlaceInTrianglesWithoutArea) {
  Random random(7);
  for (int n = 0; n < 10000; ++n) {
    const double apex = random.uniform(), height = std::pow(10, -random.uniform(14, 18));
    const Triangle2 t{Point2{0, 0}, Point2{1, 0}, Point2{apex, height}};
    const Point2 p{random.uniform(), 1e-16 * random.uniform(-1, 1)};
    ASSERT_LE(length(place(t, barycentric(t, p)) - p), 2e-14) << apex << " " << height << " " << p.x;
  }
}

// ---- located, restored

Vec3 in_space(const PackedMesh& surface, Index face, const Barycentric& b) {
  return surface.mesh().position(surface.original({face, b}));
}

/// As pieces in faces of the flat surface a segment is as long as before, and its pieces follow one another.
TEST(IntrinsicTriangulation, StraightWaysInAFaceComeBackConnectedAndAsLong) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    for_each_change(fair_meshes(seed), seed, [&](const PackedMesh& surface, auto&, const IntrinsicTriangulation& t) {
      std::size_t longest = 0;
      for (int n = 0; n < 200; ++n) {
        const Index f = static_cast<Index>(random.index(t.face_count()));
        const Barycentric from = random_coordinates(random), to = random_coordinates(random);
        std::vector<Piece> pieces;
        t.restore(f, from, to, pieces);
        ASSERT_FALSE(pieces.empty());
        longest = std::max(longest, pieces.size());
        const Triangle2 here{Point2{0, 0}, Point2{t.length(3 * f), 0}, t.apex(3 * f)};
        double sum = 0;
        for (const Piece& piece : pieces) {
          ASSERT_LT(piece.triangle, surface.face_count());
          const auto [px, py] = surface.in_frame(3 * piece.triangle, piece.from);
          const auto [qx, qy] = surface.in_frame(3 * piece.triangle, piece.to);
          sum += std::hypot(px - qx, py - qy);
        }
        ASSERT_NEAR(sum, length(place(here, to) - place(here, from)), rounding * (1 + sum));
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
          const Vec3 end = in_space(surface, pieces[i].triangle, pieces[i].to);
          ASSERT_LE(distance(end, in_space(surface, pieces[i + 1].triangle, pieces[i + 1].from)), rounding);
        }
      }
      EXPECT_GT(longest, 2u);
    });
  }
}

/// From the flat surface and back: where a point is located, a way of no length is restored to where it was.
TEST(IntrinsicTriangulation, PointsLocatedAndRestoredAreWhereTheyWere) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    for_each_change(fair_meshes(seed), seed, [&](const PackedMesh& surface, auto&, const IntrinsicTriangulation& t) {
      for (int n = 0; n < 200; ++n) {
        const SurfacePoint p{static_cast<Index>(random.index(surface.face_count())), random_coordinates(random)};
        const SurfacePoint there = t.located(p);
        ASSERT_LT(there.face, t.face_count());
        std::vector<Piece> pieces;
        t.restore(there.face, there.b, there.b, pieces);
        ASSERT_EQ(pieces.size(), 1u);
        const Vec3 back = in_space(surface, pieces[0].triangle, pieces[0].from);
        ASSERT_LE(distance(back, in_space(surface, p.face, p.b)), rounding);
      }
    });
  }
}

/// Two points near each other in a face of the mesh that come to lie in one face of the triangulation are as far from
/// each other there.
TEST(IntrinsicTriangulation, PointsKeepTheirDistances) {
  int together = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    for_each_change(fair_meshes(seed), seed, [&](const PackedMesh& surface, auto&, const IntrinsicTriangulation& t) {
      for (int n = 0; n < 200; ++n) {
        const Index f = static_cast<Index>(random.index(surface.face_count()));
        const Barycentric p = random_coordinates(random), q = random_coordinates(random);
        const SurfacePoint a = t.located({f, p}), b = t.located({f, q});
        if (a.face != b.face) continue;
        const auto [px, py] = surface.in_frame(3 * f, p);
        const auto [qx, qy] = surface.in_frame(3 * f, q);
        const Triangle2 there{Point2{0, 0}, Point2{t.length(3 * a.face), 0}, t.apex(3 * a.face)};
        const double here = std::hypot(px - qx, py - qy), apart = length(place(there, a.b) - place(there, b.b));
        ASSERT_NEAR(apart, here, rounding);
        ++together;
      }
    });
  }
  EXPECT_GT(together, 500);
}

TEST(IntrinsicTriangulation, VerticesOfTheMeshAreHitExactly) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for_each_change(all_meshes(seed), seed, [](const PackedMesh& surface, auto&, const IntrinsicTriangulation& t) {
      for (Index h = 0; h < 3 * surface.face_count(); ++h) {
        const SurfacePoint there = t.located(surface.point_on(h, 0));
        const auto corner = std::find(there.b.begin(), there.b.end(), 1.0) - there.b.begin();
        ASSERT_LT(corner, 3) << h;
        ASSERT_EQ(t.face(there.face).vertex[corner], surface.from(h));
      }
    });
}

/// With flips alone, an edge of the mesh that is still there has the points that it had, to the last bit.
TEST(IntrinsicTriangulation, PointsOfAnEdgeThatStaysAreOnIt) {
  int stayed = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    for (const auto& [name, mesh] : fair_meshes(seed)) {
      const PackedMesh surface(mesh);
      IntrinsicTriangulation t(surface, tiny);
      std::vector<bool> flipped(3 * surface.face_count(), false);
      // Only edges of even faces' first corner: the others stay.
      for (Index h = 0; h < 3 * t.face_count(); h += 6)
        if (may_flip(t, h) && !flipped[h / 3] && !flipped[t.flat_twin(h) / 3]) {
          flipped[h / 3] = flipped[t.flat_twin(h) / 3] = true;
          t.flip(h);
        }
      for (Index h = 0; h < 3 * surface.face_count(); ++h) {
        const double x = random.uniform(0.01, 0.99);
        const SurfacePoint p = surface.point_on(h, x * surface.length(h)), there = t.located(p);
        const Index from = surface.from(h), to = surface.from(SurfaceMesh::next(h));
        for (Index i = 0; i < 3; ++i) {
          const Index k = 3 * there.face + i;
          if (t.from(k) != from || t.from(SurfaceMesh::next(k)) != to || t.length(k) != surface.length(h)) continue;
          ASSERT_EQ(there.b[(i + 2) % 3], 0) << name;
          ASSERT_EQ(there.b[i], p.b[h % 3]) << name;
          ++stayed;
        }
      }
    }
  }
  EXPECT_GT(stayed, 1000);
}

}  // namespace
}  // namespace geodrome::aleksandrov::test
