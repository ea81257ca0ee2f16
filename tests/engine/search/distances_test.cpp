// SPDX-License-Identifier: MIT
// The rule of distances: places off the surface, start distances, the limit, and what no search is asked for.
#include "engine/search/distances.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/surface/place.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

double not_to_be_asked() {
  ADD_FAILURE() << "a search was asked";
  return 0;
}

Place isolated(Index vertex) { return {Place::State::isolated, {}, vertex, {}}; }

NamedPoint at(double x, double start = 0) {
  return {.place = {.state = Place::State::on_surface, .position = {x, 0, 0}}, .start = start};
}

TEST(SurfaceDistance, IsNoNumberFromOrToADroppedPlace) {
  const MeshPtr mesh = plane_grid(2);
  for (const Place& other : {Place{}, isolated(3), place_of_vertex(*mesh, 0)}) {
    EXPECT_TRUE(std::isnan(surface_distance({}, other, not_to_be_asked)));
    EXPECT_TRUE(std::isnan(surface_distance(other, {}, not_to_be_asked)));
  }
}

TEST(SurfaceDistance, OfAnIsolatedVertexIsZeroToItselfAlone) {
  const MeshPtr mesh = plane_grid(2);
  EXPECT_EQ(surface_distance(isolated(3), isolated(3), not_to_be_asked), 0);
  EXPECT_EQ(surface_distance(isolated(3), isolated(4), not_to_be_asked), infinity);
  EXPECT_EQ(surface_distance(isolated(3), place_of_vertex(*mesh, 3), not_to_be_asked), infinity);
  EXPECT_EQ(surface_distance(place_of_vertex(*mesh, 3), isolated(3), not_to_be_asked), infinity);
}

TEST(SurfaceDistance, OfPlacesOnTheSurfaceIsSearched) {
  const MeshPtr mesh = plane_grid(2);
  EXPECT_EQ(surface_distance(place_of_vertex(*mesh, 0), place_of_vertex(*mesh, 1), [] { return 7.0; }), 7);
}

TEST(DistanceRule, IsAtLeastTheStraightLineWhereTheSurfaceIsAnEstimate) {
  EXPECT_EQ(DistanceRule{.bounded = true}(2, at(0), at(3)), 3);
  EXPECT_EQ(DistanceRule{.bounded = true}(4, at(0), at(3)), 4);
  EXPECT_EQ(DistanceRule{.bounded = false}(2, at(0), at(3)), 2);
}

TEST(DistanceRule, AddsTheStartDistanceToTheBoundToo) {
  EXPECT_EQ(DistanceRule{.bounded = true}(2 + 0.5, at(0, 0.5), at(3)), 3.5);
}

TEST(DistanceRule, IsInfiniteBeyondTheLimitAlone) {
  const DistanceRule rule{.bounded = true, .limit = 3};
  EXPECT_EQ(rule(3, at(0), at(1)), 3);
  EXPECT_EQ(rule(std::nextafter(3.0, 4.0), at(0), at(1)), infinity);
  EXPECT_EQ(rule(1, at(0), at(3.5)), infinity) << "the straight line counts";
  EXPECT_EQ(rule(infinity, at(0), at(1)), infinity);
}

TEST(DistanceRule, KeepsNaN) { EXPECT_TRUE(std::isnan(DistanceRule{.bounded = true, .limit = 3}(NAN, at(0), at(1)))); }

}  // namespace
}  // namespace geodrome::test
