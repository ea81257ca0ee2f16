// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/refined_surface.hpp"

#include <gtest/gtest.h>

#include "engine/checks/surface_facts.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

TEST(CutInFour, KeepsVerticesTopologyAndShape) {
  const MeshPtr coarse = octahedron();
  const SurfaceMesh fine = cut_in_four(*coarse);
  EXPECT_EQ(fine.face_count(), 4 * coarse->face_count());
  EXPECT_EQ(fine.vertex_count(), coarse->vertex_count() + 12);
  for (Index v = 0; v < coarse->vertex_count(); ++v) EXPECT_EQ(fine.positions()[v], coarse->positions()[v]);
  EXPECT_TRUE(fine.manifold() && fine.oriented() && fine.closed());
  EXPECT_EQ(facts_of(fine).euler_number, 2);
}

TEST(CutInFour, GivesEachPartTheWeightOfItsFace) {
  const MeshPtr plain = octahedron();
  const std::vector<double> weights{1, 2, 3, 4, 5, 6, 7, 8};
  const SurfaceMesh coarse({plain->positions().begin(), plain->positions().end()},
                           {plain->triangles().begin(), plain->triangles().end()}, weights);
  const SurfaceMesh fine = cut_in_four(coarse);
  ASSERT_EQ(fine.face_weights().size(), 32u);
  for (Index f = 0; f < 32; ++f) EXPECT_EQ(fine.face_weights()[f], weights[f / 4]);
}

TEST(CutInFour, CutsAnEdgeOfThreeFacesOnce) {
  const SurfaceMesh coarse({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const SurfaceMesh fine = cut_in_four(coarse);
  EXPECT_EQ(fine.vertex_count(), 5u + 7u);
  EXPECT_FALSE(fine.manifold());
}

TEST(CutInFour, LeavesPointsInFacesWhereTheyAre) {
  const MeshPtr coarse = octahedron();
  const SurfaceMesh fine = cut_in_four(*coarse);
  std::mt19937_64 random(5);
  for (int i = 0; i < 400; ++i) {
    const double a = uniform(random), b = uniform(random) * (1 - a);
    const SurfacePoint point{static_cast<Index>(random() % 8), {a, b, 1 - a - b}};
    const SurfacePoint moved = on_quarter(point);
    EXPECT_EQ(moved.face / 4, point.face);
    EXPECT_LT(distance(fine.position(moved), coarse->position(point)), 1e-15);
    for (const double share : moved.b) EXPECT_GE(share, 0);
    EXPECT_NEAR(moved.b[0] + moved.b[1] + moved.b[2], 1, 1e-15);
  }
}

NamedPoint query(Place place) { return {place, 0, no_index, "q"}; }

TEST(RefinedSurface, HasTheSamePlaces) {
  auto surface = std::make_shared<PlacedSurface>();
  surface->mesh = octahedron();
  const SurfacePoint inside{3, {0.5, 0.25, 0.25}}, middle{0, {0.5, 0.5, 0}};
  const NamedPoint vertex = query({Place::State::on_surface, surface->mesh->at_vertex(4), 4, {0, 0, 1}}),
                   in_face = query({Place::State::on_surface, inside, no_index, surface->mesh->position(inside)}),
                   on_edge = query({Place::State::on_surface, middle, no_index, surface->mesh->position(middle)}),
                   dropped = query({});
  const ComparedSurface coarse{surface, {vertex, in_face, on_edge, dropped}, TargetList({vertex, dropped}, *surface)};
  const auto fine = refined(coarse);
  const SurfaceMesh& mesh = *fine->surface->mesh;
  ASSERT_EQ(fine->sources.size(), 4u);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(distance(mesh.position(fine->sources[i].place.at), coarse.sources[i].place.position), 1e-15) << i;
  EXPECT_EQ(fine->sources[0].place.vertex, 4u);
  EXPECT_EQ(fine->sources[1].place.vertex, no_index);
  EXPECT_GE(fine->sources[2].place.vertex, 6u) << "the middle of an edge became a vertex";
  EXPECT_EQ(fine->sources[3].place.state, Place::State::dropped);
  EXPECT_EQ(mesh.vertex_at(fine->targets.named()[0].place.at), 4u);
}

}  // namespace
}  // namespace geodrome::test
