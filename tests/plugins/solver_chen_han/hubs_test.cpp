// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "plugins/solver_chen_han/rows/direct_search.hpp"
#include "tests/plugins/solver_chen_han/rows_fixture.hpp"

/// Hubs, vertices of thousands of faces: what adds up around them, how many paths leave them, what they cost.
namespace geodrome::test {
namespace {

using namespace chen_han;

/// A cone around vertex 0 and another one around vertex 1 with a rim of `count` vertices, from 2 on, in common. The
/// first one is flat, of radius 1, and goes `turns` times around its apex, through itself; the second is `height` high,
/// so that all else is convex if turns < sqrt(1 + height^2). Whole halves of turns: the rim is open, or closed.
MeshPtr double_fan(Index count, double turns, double height) {
  const bool closed = turns == std::floor(turns);
  const Index rim = closed ? count : count + 1;
  std::vector<Vec3> positions{{0, 0, 0}, {0, 0, height}};
  std::vector<Triangle> triangles;
  for (Index i = 0; i < rim; ++i) {
    const double at = 2 * std::numbers::pi * turns * i / count;
    positions.push_back({std::cos(at), std::sin(at), 0});
  }
  for (Index i = 0; i < count; ++i) {
    const Index here = 2 + i, next = 2 + (i + 1) % rim;
    triangles.push_back({0, here, next}), triangles.push_back({1, next, here});
  }
  return shapes::small::make(std::move(positions), std::move(triangles));
}

/// `rings` rings of `count` vertices around vertex 0, by turns far above and below it, so that its faces are wide.
MeshPtr star(Index count, Index rings) {
  shapes::Random random(3);
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<Triangle> triangles;
  for (Index ring = 1; ring <= rings; ++ring)
    for (Index i = 0; i < count; ++i) {
      const double at = 2 * std::numbers::pi * i / count, r = ring * random.uniform(0.9, 1.1);
      positions.push_back({r * std::cos(at), r * std::sin(at), i % 2 ? -2 * r : 2 * r});
    }
  for (Index i = 0; i < count; ++i) {
    const Index next = (i + 1) % count;
    triangles.push_back({0, 1 + i, 1 + next});
    for (Index ring = 1; ring < rings; ++ring) {
      const Index a = 1 + (ring - 1) * count, b = a + count;
      triangles.push_back({a + i, b + i, b + next}), triangles.push_back({a + i, b + next, a + next});
    }
  }
  return shapes::small::make(std::move(positions), std::move(triangles));
}

/// Of so many equal angles every error would add to that of all others.
TEST(Hubs, HaveAnglesThatAddUp) {
  constexpr Index faces = 60000;
  const MeshPtr mesh = double_fan(faces, 2.5, 3);
  const PackedMesh fan(mesh);
  const CornerAngles angles(fan);
  const Index hub = fan.vertex_of_original(0);
  const double step = 2 * std::asin(std::sin(2.5 * std::numbers::pi / faces));
  Index i = 0;
  for (const Index corner : fan.corners(hub)) ASSERT_NEAR(radians(angles.start(corner)), step * i++, 1e-9) << i;
  EXPECT_NEAR(angles.total(hub), step * faces, 1e-9);
}

/// From a vertex of the rim across the needles: the turns at all of them have the same sign.
TEST(Hubs, AreCrossedInDirectionsThatAreExact) {
  constexpr Index faces = 20000;
  const PackedMesh surface(double_fan(faces, 1.5, 3));
  QuietContext context;
  const DirectGround ground(surface, {}, context);
  DirectSearch search(surface, {}, ground);
  const auto rim = [&](Index i) { return surface.vertex_of_original(2 + i); };
  std::set<Index> found;
  for (const FoundPath& path : search.run(rim(0), infinity, context)) found.insert(path.target);
  const double to_hub = radians(search.direct().exit_along_edge(surface.vertex_of_original(0)));
  for (const Index i : {100, 1000, 4000, 6000}) {
    ASSERT_TRUE(found.contains(rim(i))) << i;
    const Bearing exit = search.direct().exit(rim(i));
    ASSERT_TRUE(is_known(exit)) << i;
    const double around_hub = i * 3 * std::numbers::pi / faces;
    EXPECT_NEAR(std::abs(radians(exit) - to_hub), (std::numbers::pi - around_hub) / 2, 1e-9) << i;
  }
}

/// More paths leave the apex than 16 bits count.
TEST(Hubs, HaveRowsAsPlainSearchesTellWithMorePathsThan16BitsCount) {
  const MeshPtr mesh = double_fan(66000, 3, 4);
  std::vector<SurfacePoint> sources{mesh->at_vertex(0)};
  for (const Index i : {2U, 3U, 30000U, 65000U}) sources.push_back(mesh->at_vertex(i));
  constexpr double within = 2.5;  // all of the rim, but not the other apex
  Planned planned(mesh, sources, within);
  ASSERT_TRUE(planned) << planned.told();
  EXPECT_LE(planned.worst({.radius = within}), row_rounding);
  const std::vector<double> row = Planned::distances(planned.row(sources[1], {.radius = within}));
  EXPECT_NEAR(row[2 + 33000], 2, 1e-12) << "over the apex";
  EXPECT_EQ(row[1], infinity);
  EXPECT_GT(std::count_if(row.begin(), row.end(), [](double d) { return std::abs(d - 2) < 1e-12; }), 40000);
}

/// Around a vertex of many wide faces the search for near vertices costs as much as a whole row.
TEST(Hubs, MakeListsTooDearToFindOutAbout) {
  const MeshPtr mesh = star(5000, 3);
  std::vector<SurfacePoint> sources = all_vertices(*mesh);
  sources.resize(6000);
  const Planned planned(mesh, sources, infinity, "rows=auto");
  EXPECT_FALSE(planned);
  EXPECT_NE(planned.told().find("so few or so short searches"), std::string::npos) << planned.told();
}

}  // namespace
}  // namespace geodrome::test
