// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/intrinsic/delaunay.hpp"

#include <algorithm>

#include "tests/plugins/solver_aleksandrov/intrinsic_fixture.hpp"

namespace geodrome::aleksandrov::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_angle = pi / 9;

/// Of angles, ties among them.
constexpr double rounding = 1e-9;

void expect_delaunay(const IntrinsicTriangulation& t) {
  for (Index h = 0; h < 3 * t.face_count(); ++h) {
    const Index g = t.flat_twin(h);
    if (g != no_index) {
      ASSERT_LE(opposite_angles(t, g, h), pi + rounding) << "half-edge " << h;
    }
  }
}

IntrinsicTriangulation delaunay(const PackedMesh& surface) {
  const QuietContext context;
  IntrinsicTriangulation t(surface, tiny);
  make_delaunay(t, context);
  return t;
}

double smallest_angle(const IntrinsicTriangulation& t) {
  double least = pi;
  for (Index h = 0; h < 3 * t.face_count(); ++h) least = std::min(least, angle(t, h));
  return least;
}

/// The angle from one edge that cannot be flipped to the next around the corner of `h`, or all around; on a surface,
/// what no triangulation can change.
double angle_of_surface(const IntrinsicTriangulation& t, Index h) {
  double whole = angle(t, h);
  for (Index c = h, g; (g = t.flat_twin(SurfaceMesh::previous(c))) != no_index; whole += angle(t, c))
    if ((c = g) == h) return whole;
  for (Index c = h, g; (g = t.flat_twin(c)) != no_index; whole += angle(t, c)) c = SurfaceMesh::next(g);
  return whole;
}

TEST(Delaunay, AnglesOppositeToEdgesThatCanBeFlippedHaveNoSumAbovePi) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (const auto& [name, mesh] : all_meshes(seed)) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const PackedMesh surface(mesh);
      expect_delaunay(delaunay(surface));
    }
}

TEST(Delaunay, IsFoundFromAnyTriangulationOfTheSameSurface) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const QuietContext context;
    for (const auto& [name, mesh] : fair_meshes(seed)) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const PackedMesh surface(mesh);
      const IntrinsicTriangulation direct = delaunay(surface);
      IntrinsicTriangulation t(surface, tiny);
      for (int i = 0; i < 300; ++i) {
        const Index h = static_cast<Index>(random.index(3 * t.face_count()));
        if (may_flip(t, h)) t.flip(h);
      }
      make_delaunay(t, context);
      expect_delaunay(t);
      ASSERT_NEAR(smallest_angle(t), smallest_angle(direct), rounding);
    }
  }
}

/// Two faces without area, or nearly, on one long edge: the sum of the opposite angles is about 2 pi.
TEST(Delaunay, FlipsTheLongEdgeOfTwoFlatCaps) {
  for (const double height : {0.0, 1e-14, 1e-12, 1e-9, 1e-5, 1e-2}) {
    SCOPED_TRACE(testing::Message() << "height " << height);
    const PackedMesh surface(
        geodrome::test::make({{0, 0, 0}, {2, 0, 0}, {0.5, height, 0}, {1.2, -height, 0}, {1, 1, 0}, {1, -1, 0}},
                             {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}, {3, 0, 5}, {1, 3, 5}}));
    const IntrinsicTriangulation t = delaunay(surface);
    const double longest = std::ldexp(1.9, surface.exponent());
    for (Index h = 0; h < 3 * t.face_count(); ++h) EXPECT_LT(t.length(h), longest);
  }
}

/// Angles are fair, or the surface has them: thin faces stay only at its own sharp corners, and where edges that cannot
/// be flipped end there, which are not split.
TEST(Refinement, LeavesNoAngleBelowTheBoundThatTheSurfaceHasNot) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const QuietContext context;
    for (const auto& [name, mesh] : fair_meshes(seed)) {
      if (name == "finned terrain" || name == "Moebius strip") continue;  // sharp corners all along
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const PackedMesh surface(mesh);
      IntrinsicTriangulation t = delaunay(surface);
      refine(t, least_angle, 100000, context);
      expect_delaunay(t);
      std::vector<bool> sharp(t.vertex_count(), false);
      for (Index h = 0; h < 3 * t.face_count(); ++h)
        if (angle_of_surface(t, h) < pi / 3) sharp[t.from(h)] = true;
      for (Index h = 0; h < 3 * t.face_count(); ++h) {
        const auto& vertex = t.face(h / 3).vertex;
        const bool excused = std::any_of(vertex.begin(), vertex.end(), [&](Index v) { return sharp[v]; });
        if (!excused) {
          ASSERT_GE(angle(t, h), least_angle - rounding) << "half-edge " << h;
        }
      }
    }
  }
}

TEST(Refinement, LeavesTheSurfaceAsItIs) {
  const QuietContext context;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const auto& [name, mesh] : fair_meshes(seed)) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const PackedMesh surface(mesh);
      const IntrinsicTriangulation before = delaunay(surface);
      IntrinsicTriangulation t = before;
      const Index inserted = refine(t, least_angle, 100000, context);
      ASSERT_EQ(t.vertex_count(), before.vertex_count() + inserted);
      ASSERT_EQ(euler_number(t), euler_number(before));
      ASSERT_NEAR(area(t), area(before), 1e-11 * area(before));
    }
}

/// Faces without area too. The strips of stretched-1000 are thin as a surface and take more than they are given.
TEST(Refinement, EndsOnHostileMeshesLongBeforeItsBound) {
  const QuietContext context;
  for (const shapes::HostileFamily& family : shapes::hostile_families()) {
    if (family.name == "stretched-1000") continue;
    const PackedMesh surface(std::make_shared<const SurfaceMesh>(family.make(0, 1)));
    IntrinsicTriangulation t = delaunay(surface);
    EXPECT_LE(refine(t, least_angle, 20000, context), 7 * surface.face_count()) << family.name;
    EXPECT_LT(t.vertex_count(), surface.vertex_count() + 20000) << family.name;
  }
}

TEST(Refinement, StopsAtItsBound) {
  const QuietContext context;
  const PackedMesh surface(std::make_shared<const SurfaceMesh>(shapes::hostile("stretched-1000", 0)));
  for (const Index most : {0, 1, 2, 1000}) {
    IntrinsicTriangulation t = delaunay(surface);
    EXPECT_EQ(refine(t, least_angle, most, context), most);
    expect_delaunay(t);
  }
}

}  // namespace
}  // namespace geodrome::aleksandrov::test
