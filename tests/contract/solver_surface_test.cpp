// SPDX-License-Identifier: MIT
// Every solver: kinds of surfaces, and the audit.
#include <algorithm>

#include "contract/solver_contract.hpp"
#include "geodrome/engine/audit.hpp"

namespace geodrome::test {
namespace {

class SolverSurfaces : public SolverContract {
 protected:
  void expect_sound(const MeshPtr& mesh, const std::vector<Source>& sources) {
    Running running(plugin(), mesh);
    const AuditResult result = audit(*mesh, sources, running.map(sources), plugin().provides,
                                     {.factor = plugin().factor, .points_per_edge = 3});
    EXPECT_GT(result.paths, 0u);
    EXPECT_LE(result.worst_lipschitz, rounding) << result.where;
    EXPECT_LE(result.worst_path, rounding) << result.where;
  }
};

TEST_P(SolverSurfaces, AnotherComponentIsUnreachable) {
  const MeshPtr mesh = both(octahedron(), mapped(octahedron(), [](const Vec3& p) { return p + Vec3{5, 0, 0}; }));
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  const ShortestPathMap& map = running.run({{mesh->at_vertex(0)}});
  for (Index v = 0; v < 6; ++v) EXPECT_TRUE(std::isfinite(map.vertices()[v])) << v;
  for (Index v = 6; v < 12; ++v) {
    EXPECT_EQ(map.vertices()[v], infinity) << v;
    EXPECT_EQ(map.at(mesh->at_vertex(v)).reach, Reach::unreachable) << v;
    EXPECT_EQ(map.at(mesh->at_vertex(v)).source, no_index) << v;
  }
}

TEST_P(SolverSurfaces, VerticesOnNoFaceAreUnreachable) {
  const MeshPtr whole = octahedron();
  std::vector<Vec3> positions{{9, 9, 9}};
  positions.insert(positions.end(), whole->positions().begin(), whole->positions().end());
  positions.push_back({0, 0, 0});
  std::vector<Triangle> triangles;
  for (const Triangle& t : whole->triangles()) triangles.push_back({t[0] + 1, t[1] + 1, t[2] + 1});
  const MeshPtr mesh = make(positions, triangles);
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  const auto values = running.run({{mesh->at_vertex(1)}}).vertices();
  EXPECT_EQ(values[0], infinity);
  EXPECT_EQ(values[7], infinity);
  expect_distance(values[2], 2 * std::sqrt(1.5), 3, "opposite corner");
}

TEST_P(SolverSurfaces, AFaceWithoutAreaIsCrossed) {
  const MeshPtr mesh =
      make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 4, 2}});
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  const auto values = copy(running.run({{mesh->at_vertex(3)}}).vertices());
  if (exact()) {
    EXPECT_NEAR(values[4], 2, rounding);
  }
  for (Index v = 0; v < 5; ++v) {
    const auto from = running.run({{mesh->at_vertex(v)}}).vertices();
    for (Index w = 0; w < 5; ++w) expect_distance(from[w], distance(mesh->positions()[v], mesh->positions()[w]), 2);
  }
}

/// Faces without area at random places: every third interior edge of a grid gets its midpoint as a vertex on one side
/// only.
TEST_P(SolverSurfaces, ManyFacesWithoutAreaAreCrossed) {
  const MeshPtr grid = plane_grid(6);
  std::vector<Vec3> positions(grid->positions().begin(), grid->positions().end());
  std::vector<Triangle> triangles;
  for (Index f = 0; f < grid->face_count(); ++f) {
    const auto [a, b, c] = grid->triangles()[f];
    if (f % 3 || grid->twins()[3 * f] == no_index) {
      triangles.push_back({a, b, c});
      continue;
    }
    const auto middle = static_cast<Index>(positions.size());
    positions.push_back((positions[a] + positions[b]) / 2);
    triangles.push_back({a, middle, c}), triangles.push_back({middle, b, c}), triangles.push_back({a, b, middle});
  }
  const MeshPtr mesh = make(positions, triangles);
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  for (Index v = 0; v < mesh->vertex_count(); v += 7) {
    const auto from = running.run({{mesh->at_vertex(v)}}).vertices();
    for (Index w = 0; w < mesh->vertex_count(); ++w)
      expect_distance(from[w], distance(positions[v], positions[w]), 9, "vertex pair");
  }
}

TEST_P(SolverSurfaces, FarFromTheOriginDistancesAreThoseOfTheCoordinates) {
  const MeshPtr mesh = mapped(octahedron(), [](const Vec3& p) { return p + Vec3{1e8, 1e8, 0}; });
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  const auto values = running.run({{mesh->at_vertex(0)}}).vertices();
  expect_distance(values[1], 2 * std::sqrt(1.5), 3, "opposite corner");
  expect_distance(values[2], std::sqrt(2), 3, "neighbour");
}

TEST_P(SolverSurfaces, ABowTieIsPassedThroughItsVertex) {
  const MeshPtr mesh = bow_tie();
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  EXPECT_NEAR(running.run({{mesh->at_vertex(1)}}).vertices()[3], 2 * std::sqrt(2), rounding);
}

TEST_P(SolverSurfaces, AnEdgeOfThreeFacesIsPassed) {
  const MeshPtr mesh = book();
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  const auto values = running.run({{mesh->at_vertex(2)}}).vertices();
  const double across =
      std::sqrt(2) + 1;  // the three leaves unfold to pairs of triangles that share the edge of length 1
  expect_distance(values[3], across, 3, "second leaf");
  expect_distance(values[4], across, 3, "third leaf");
}

TEST_P(SolverSurfaces, AMoebiusStripIsFinite) {
  const MeshPtr mesh = moebius(24);
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  for (const double value : running.run({{mesh->at_vertex(0)}}).vertices()) EXPECT_TRUE(std::isfinite(value));
}

TEST_P(SolverSurfaces, PassTheAuditOnABumpyTorus) {
  GEODROME_NEEDS(any_point | paths);
  const MeshPtr mesh = bumpy_torus(18, 10, 0.08, 31);
  GEODROME_FITS(mesh);
  expect_sound(mesh, {{mesh->at_vertex(11)}});
}

TEST_P(SolverSurfaces, PassTheAuditOnTerrainWithManySources) {
  GEODROME_NEEDS(any_point | paths | face_sources);
  const MeshPtr mesh = terrain(12, 3, 37);
  GEODROME_FITS(mesh);
  std::mt19937_64 random(41);
  std::vector<Source> sources;
  for (int i = 0; i < 5; ++i) sources.push_back({random_point(*mesh, random)});
  expect_sound(mesh, sources);
}

TEST_P(SolverSurfaces, PassTheAuditWithStartDistances) {
  GEODROME_NEEDS(any_point | paths | face_sources | start_distances);
  const MeshPtr mesh = terrain(12, 1, 43);
  GEODROME_FITS(mesh);
  std::mt19937_64 random(47);
  std::vector<Source> sources;
  for (int i = 0; i < 5; ++i) sources.push_back({random_point(*mesh, random), 3 * uniform(random)});
  expect_sound(mesh, sources);
}

/// Exact symmetry: straight lines run through flat vertices, where windows meet.
TEST_P(SolverSurfaces, PassTheAuditOnAPlaneAndACube) {
  GEODROME_NEEDS(any_point | paths);
  for (const MeshPtr& mesh : {plane_grid(8), plane_grid(8, true), cube(), prism(12, 8, 0.2)}) {
    GEODROME_FITS(mesh);
    expect_sound(mesh, {{mesh->at_vertex(0)}});
    expect_sound(mesh, {{mesh->at_vertex(static_cast<Index>(mesh->vertex_count() / 2))}});
  }
}

TEST_P(SolverSurfaces, PassTheAuditOnNeedles) {
  GEODROME_NEEDS(any_point | paths);
  const MeshPtr mesh = mapped(terrain(9, 1, 53), [](const Vec3& p) { return Vec3{p.x, 300 * p.y, p.z}; });
  GEODROME_FITS(mesh);
  expect_sound(mesh, {{mesh->at_vertex(44)}});
}

INSTANTIATE_TEST_SUITE_P(Every, SolverSurfaces, testing::ValuesIn(discovered<ShortestPathSolver>()), plugin_name);

}  // namespace
}  // namespace geodrome::test
