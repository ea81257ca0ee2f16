// SPDX-License-Identifier: MIT
#include "engine/checks/worst_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sample_surfaces.hpp"

namespace geodrome {
namespace {

using test::sampled;
using test::SampledSurface;

constexpr Index side = 40;  ///< squares of the grid

/// A grid whose squares have side 1, with a psi that all claims hold for.
SampledSurface grid() { return sampled(test::plane_grid(side), 0.9); }
Index vertex(Index i, Index j) { return i * (side + 1) + j; }

std::vector<WorstPlace> worst_of(const SampledSurface& made, const std::vector<Finding>& findings = {}) {
  return worst_places(made.input, made.surface, claims_of(made.surface, 1), findings);
}

Finding warning(const char* code, std::vector<Index> elements) {
  return {Finding::Severity::warning, code, "m", elements.size(), std::move(elements)};
}

/// The point itself, or the other end of one of its edges: both are where an edge is too long.
bool is_at(const WorstPlace& place, const Vec3& defect) { return distance(place.position, defect) < 1.5; }

bool any_is_at(const std::vector<WorstPlace>& places, const Vec3& defect) {
  return std::any_of(places.begin(), places.end(), [&](const WorstPlace& place) { return is_at(place, defect); });
}

TEST(WorstPlaces, BeginWhereAPsiWasMadeTooSmall) {
  SampledSurface made = grid();
  made.surface.sample->control.psi[vertex(20, 7)] = 0.2;
  const std::vector<WorstPlace> places = worst_of(made);
  ASSERT_FALSE(places.empty());
  EXPECT_TRUE(is_at(places[0], {20, 7, 0}));
  EXPECT_EQ(places[0].position, made.input.positions[places[0].row]);
  EXPECT_TRUE(places[0].troubles[0].fails);
  EXPECT_FALSE(places[0].troubles[0].remedy.empty());
}

TEST(WorstPlaces, AreTenDifferentOnes) {
  const std::vector<WorstPlace> places = worst_of(grid());
  ASSERT_EQ(places.size(), worst_places_shown);
  for (const WorstPlace& a : places)
    for (const WorstPlace& b : places)
      EXPECT_TRUE(&a == &b || distance(a.position, b.position) > 5 * 0.9) << a.row << " " << b.row;
}

TEST(WorstPlaces, TellOfANeighbourhoodEverythingThatFailsThere) {
  SampledSurface made = grid();
  made.surface.sample->control.psi[vertex(20, 7)] = 0.2;
  const std::vector<WorstPlace> places = worst_of(made, {warning("boundary", {vertex(20, 8)})});
  std::vector<std::string> codes;
  for (const Trouble& trouble : places[0].troubles) codes.push_back(trouble.code);
  for (const char* code : {"boundary", "edge_to_psi", "circumradius_to_psi", "psi_lipschitz"})
    EXPECT_EQ(std::count(codes.begin(), codes.end(), code), 1) << code;
}

TEST(WorstPlaces, PutRefusalsBeforeWarnings) {
  const Finding refusal{Finding::Severity::refusal, "inconsistent_stars", "m", 1, {vertex(3, 3)}};
  const std::vector<WorstPlace> places = worst_of(grid(), {warning("boundary", {vertex(30, 30)}), refusal});
  EXPECT_EQ(places[0].row, vertex(3, 3));
  EXPECT_EQ(places[1].row, vertex(30, 30));
}

TEST(WorstPlaces, LeaveRoomForEveryKindOfTrouble) {
  SampledSurface made = grid();
  made.surface.sample->control.psi[vertex(38, 38)] = 0.2;
  std::vector<Index> many;
  for (Index i = 0; i < 15; ++i) many.push_back(vertex(2 + 6 * (i % 5), 2 + 6 * (i / 5)));
  const std::vector<WorstPlace> places = worst_of(made, {warning("inconsistent_stars", many)});
  EXPECT_EQ(places.size(), worst_places_shown);
  EXPECT_TRUE(any_is_at(places, {38, 38, 0}));
}

TEST(WorstPlaces, PassOverNotes) {
  const Finding note{Finding::Severity::note, "boundary", "m", 1, {vertex(11, 13)}};
  for (const WorstPlace& place : worst_of(grid(), {note}))
    for (const Trouble& trouble : place.troubles) EXPECT_NE(trouble.code, "boundary");
}

TEST(WorstPlaces, AreNamedByTheRowOfTheFile) {
  SampledSurface made = grid();
  made.surface.sample->control.psi[vertex(20, 7)] = 0.2;
  made.input.element_of_row.insert(made.input.element_of_row.begin(), {no_index, no_index});
  made.surface.places.insert(made.surface.places.begin(), 2, Place{});
  const WorstPlace first = worst_of(made)[0];
  EXPECT_TRUE(is_at(first, {20, 7, 0}));
  EXPECT_EQ(first.position, made.input.positions[first.row - 2]);
}

TEST(WorstPlaces, OfAStrangersFindingThatNamesNoPointAreNone) {
  const std::vector<WorstPlace> places = worst_of(grid(), {warning("odd", {no_index, 1'000'000})});
  for (const WorstPlace& place : places) EXPECT_NE(place.troubles[0].code, "odd");
}

TEST(WorstPlaces, OfARefusedSampleComeFromItsFindings) {
  SampledSurface made = grid();
  test::refuse(made);
  const Finding refusal{Finding::Severity::refusal, "inconsistent_stars", "m", 2, {vertex(3, 3), vertex(20, 20)}};
  const std::vector<WorstPlace> places = worst_of(made, {refusal});
  ASSERT_GE(places.size(), 2u);
  EXPECT_EQ(places[0].row, vertex(3, 3));
  EXPECT_EQ(places[1].row, vertex(20, 20));
}

}  // namespace
}  // namespace geodrome
