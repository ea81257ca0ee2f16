// SPDX-License-Identifier: MIT
// The parts of --query insert and --query printed: who is refused, where targets lie on a surface with the source.
#include "engine/search/projection_rule.hpp"

#include <gtest/gtest.h>

#include "engine/search/printed_rule.hpp"
#include "engine/search/relocation.hpp"
#include "plugins/common/surfaces/surface_inserter.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

Opened opened_points(bool with_inserter) {
  Opened opened;
  opened.input.kind = InputKind::points;
  opened.surface.made_from = InputKind::points;
  opened.surface.mesh = plane_grid(2);
  PluginInfo reconstructor;
  reconstructor.stage = "reconstructor", reconstructor.name = "plain";
  opened.surface.stages.push_back({reconstructor});
  if (with_inserter) opened.surface.inserter = make_inserter(opened.surface.mesh, {}, {});
  return opened;
}

NamedPoint row(Index i) { return {Place{}, 0, i, std::to_string(i)}; }

TEST(ProjectionRule, AReconstructorThatCannotInsertIsNamed) {
  const Opened opened = opened_points(false);
  const NamedPoint source = row(0);
  EXPECT_NO_THROW(check_rule(ProjectionRule::project, opened, {&source, 1}));
  for (const ProjectionRule rule : {ProjectionRule::insert, ProjectionRule::printed}) try {
      check_rule(rule, opened, {&source, 1});
      ADD_FAILURE() << name(rule) << " was accepted";
    } catch (const CapabilityError& error) {
      EXPECT_NE(std::string(error.what()).find("reconstructor_plain"), std::string::npos) << error.what();
    }
}

TEST(ProjectionRule, SourcesThatAreNoRowsAreRefused) {
  const Opened opened = opened_points(true);
  const NamedPoint sources[] = {row(0), row(no_index)};
  EXPECT_NO_THROW(check_rule(ProjectionRule::insert, opened, {sources, 1}));
  EXPECT_THROW(check_rule(ProjectionRule::insert, opened, sources), OptionError);
  EXPECT_NO_THROW(check_rule(ProjectionRule::project, opened, sources));
}

TEST(ProjectionRule, AMeshIsRefused) {
  Opened opened = opened_points(true);
  opened.input.kind = InputKind::mesh;
  const NamedPoint source = row(0);
  EXPECT_THROW(check_rule(ProjectionRule::insert, opened, {&source, 1}), OptionError);
}

/// Places of random points beside a surface.
std::vector<NamedPoint> places_near(const MeshPtr& mesh, const SurfaceLocator& locator, std::size_t count, double off) {
  std::mt19937_64 random(4);
  std::vector<NamedPoint> queries;
  for (Index i = 0; i < count; ++i) {
    const Vec3 move{uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5};
    const Vec3 position = mesh->position(random_point(*mesh, random)) + off * move;
    const SurfacePoint at = locator.closest(position).at;
    queries.push_back({{Place::State::on_surface, at, mesh->vertex_at(at), position}, 0, i, std::to_string(i)});
  }
  return queries;
}

void expect_as_located(const std::vector<NamedPoint>& places, const MeshPtr& mesh) {
  const SurfaceLocator locator(mesh);
  for (const NamedPoint& query : places) {
    const SurfacePoint at = locator.closest(query.place.position).at;
    EXPECT_EQ(query.place.at, at) << query.label;
    EXPECT_EQ(query.place.vertex, mesh->vertex_at(at)) << query.label;
  }
}

TEST(Relocation, FindsBitwiseWhatALocatorOfTheNewSurfaceFinds) {
  for (const MeshPtr& mesh : {bumpy_torus(14, 8, 0.05, 2), plane_grid(6), terrain(6, 0.8, 1)}) {
    const SurfaceLocator locator(mesh);
    const std::vector<NamedPoint> old = places_near(mesh, locator, 300, 0.3);
    PointSample sample;
    for (const NamedPoint& query : old) sample.points.push_back(query.place.position);
    const auto inserter = make_inserter(mesh, {}, sample);
    for (Index s = 0; s < 40; ++s) {
      const MeshPtr changed = inserter->with(s).mesh;
      std::vector<NamedPoint> places = old;
      relocate(places, *mesh, locator, changed);
      expect_as_located(places, changed);
    }
  }
}

TEST(Relocation, ManagesASurfaceOfWhichNothingStayed) {
  const MeshPtr mesh = plane_grid(40);
  std::vector<Triangle> turned(mesh->triangles().begin(), mesh->triangles().end());
  for (Triangle& t : turned) t = {t[1], t[2], t[0]};
  const MeshPtr other = make({mesh->positions().begin(), mesh->positions().end()}, turned);
  const SurfaceLocator locator(mesh);
  std::vector<NamedPoint> places = places_near(mesh, locator, 50, 0.3);
  relocate(places, *mesh, locator, other);
  expect_as_located(places, other);
}

TEST(Relocation, LeavesWhatIsOnNoSurface) {
  const MeshPtr mesh = plane_grid(2), other = plane_grid(3);
  std::vector<NamedPoint> places{row(0)};
  relocate(places, *mesh, SurfaceLocator(mesh), other);
  EXPECT_EQ(places[0].place.state, Place::State::dropped);
  EXPECT_EQ(places[0].place.vertex, no_index);
}

TEST(PrintedRule, TheNearestVertexIsThatOfBruteForceTiesTheLowest) {
  const MeshPtr mesh = plane_grid(9);
  const VertexLocator vertices(*mesh);
  std::mt19937_64 random(6);
  for (int i = 0; i < 300; ++i) {
    // Halves make ties of two and four vertices.
    const Vec3 query{static_cast<double>(random() % 20) / 2, static_cast<double>(random() % 20) / 2, uniform(random)};
    std::pair<double, Index> best{INFINITY, no_index};
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      best = std::min(best, {squared_distance(query, mesh->positions()[v]), v});
    EXPECT_EQ(vertices.nearest(query), best.second) << query.x << " " << query.y;
  }
}

TEST(PrintedRule, EveryFaceAtAVertexGivesItsClosestPointOnce) {
  for (const MeshPtr& mesh : {plane_grid(4), bumpy_torus(10, 7, 0.05, 1)}) {
    std::vector<std::size_t> degree(mesh->vertex_count());
    for (const Triangle& t : mesh->triangles())
      for (const Index v : t) ++degree[v];
    const Vec3 query{0.3, 0.9, 0.2};
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const std::vector<SurfacePoint> points = closest_on_faces_at(*mesh, v, query);
      std::vector<Index> faces;
      for (const SurfacePoint& point : points) {
        faces.push_back(point.face);
        EXPECT_NE(std::ranges::find(mesh->triangles()[point.face], v), mesh->triangles()[point.face].end());
      }
      std::ranges::sort(faces);
      EXPECT_EQ(std::ranges::adjacent_find(faces), faces.end());
      EXPECT_EQ(faces.size(), degree[v]);
    }
  }
}

}  // namespace
}  // namespace geodrome::test
