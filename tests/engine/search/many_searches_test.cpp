// SPDX-License-Identifier: MIT
// The plan of a job's rows: which places of which sources a solver with the extension ManySearches is told of.
#include "engine/search/many_searches.hpp"

#include <gtest/gtest.h>

#include "engine/surface/place.hpp"
#include "geodrome/plugin.hpp"
#include "tests/support/analytic_surfaces.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

constexpr ManySearches table{
    [](const PreparedSurface&, const SearchPlan&, RunContext&) { return std::unique_ptr<PreparedSurface>(); }};

class RowPlans : public testing::Test {
 protected:
  NamedPoint vertex(Index v, double start = 0) const { return {.place = place_of_vertex(*mesh_, v), .start = start}; }
  std::optional<RowPlan> plan(const std::vector<NamedPoint>& sources, double max_distance = infinity) const {
    return plan_rows(solver_, ProjectionRule::project, sources, max_distance);
  }

  const MeshPtr mesh_ = plane_grid(3);
  PreparedSolver solver_{.plugin = {.find_extension = extensions<table>}};
};

TEST_F(RowPlans, HoldEachPlaceOnceInWhateverOrderTheListHas) {
  const NamedPoint in_face{.place = place_on(*mesh_, {3, {0.25, 0.25, 0.5}}, {})};
  const auto one = plan({vertex(5), in_face, vertex(0), vertex(5)}), other = plan({vertex(0), vertex(5), in_face});
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->sources.size(), 3u);
  EXPECT_EQ(one->sources, other->sources);
  EXPECT_EQ(one->radius, infinity);
}

TEST_F(RowPlans, LeaveOutWhatIsNotSearchedFrom) {
  const NamedPoint isolated{.place = {Place::State::isolated, {}, 7, {}}}, dropped{};
  const auto found = plan({isolated, vertex(1), dropped, vertex(2), vertex(3, 2.5)}, 2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->sources, (std::vector{mesh_->at_vertex(1), mesh_->at_vertex(2)}));
}

TEST_F(RowPlans, ReachAsFarAsTheSourceThatStartsFirst) {
  EXPECT_EQ(plan({vertex(1, 0.5), vertex(2, 1.5)}, 2)->radius, 1.5);
  EXPECT_EQ(plan({vertex(1, 0.5), vertex(2, 1.5)})->radius, infinity);
}

TEST_F(RowPlans, AreNotMadeOfFewerThanTwoPlaces) {
  EXPECT_FALSE(plan({}));
  EXPECT_FALSE(plan({vertex(1), vertex(1), {}}));
  EXPECT_TRUE(plan({vertex(1), vertex(2)}));
}

TEST_F(RowPlans, AreNotMadeWhereSourcesHaveSurfacesOfTheirOwn) {
  const std::vector<NamedPoint> sources{vertex(1), vertex(2)};
  EXPECT_FALSE(plan_rows(solver_, ProjectionRule::insert, sources, infinity));
  EXPECT_FALSE(plan_rows(solver_, ProjectionRule::printed, sources, infinity));
}

TEST_F(RowPlans, AreNotMadeWherePathsAreWanted) {
  const auto surface = std::make_shared<const AnalyticSurface<Plane>>(mesh_);
  solver_.smooth = metric_of({.mesh = mesh_, .smooth = FittedSurface{.surface = surface}});
  EXPECT_FALSE(plan({vertex(1), vertex(2)}));
}

TEST_F(RowPlans, AreNotMadeForASolverWithoutTheExtension) {
  solver_.plugin.find_extension = nullptr;
  EXPECT_FALSE(plan({vertex(1), vertex(2)}));
}

}  // namespace
}  // namespace geodrome::test
