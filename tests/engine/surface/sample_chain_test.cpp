// SPDX-License-Identifier: MIT
// Stages 1 to 4 for several choices, and parts of samples.
#include "engine/surface/sample_chain.hpp"

#include <gtest/gtest.h>

#include "engine/jobs/compare/growth.hpp"
#include "tests/support/samples.hpp"

namespace geodrome::test {
namespace {

class SampleChains : public testing::Test {
 protected:
  SampleChains() {
    input_.kind = InputKind::points;
    Random random(4);
    for (Index i = 0; i < 300; ++i) {  // a sphere
      input_.positions.push_back(random.direction());
      input_.element_of_row.push_back(i);
    }
    settings_.threads = 1;
  }
  static StageChoice with(const std::string& decimator, const std::string& reconstructor = "delaunay_cut") {
    StageChoice choice;
    choice.decimator = decimator, choice.reconstructor = reconstructor;
    return choice;
  }

  Input input_;
  RunSettings settings_;
  PluginHost host_;
  Observer observer_;
};

TEST_F(SampleChains, GiveWhatEachChoiceGivesAlone) {
  SampleChain chain(input_, host_, settings_, observer_);
  for (const StageChoice& choice : {with("greedy"), with("none"), with("none", "advancing_front"), with("greedy")}) {
    RunSettings alone = settings_;
    alone.stages = choice;
    const PlacedSurface expected = make_surface(input_, host_, alone, observer_);
    const SurfaceAttempt made = chain.make(choice);
    ASSERT_FALSE(made.refusal);
    EXPECT_TRUE(std::ranges::equal(made.surface.mesh->triangles(), expected.mesh->triangles()));
    EXPECT_TRUE(std::ranges::equal(made.surface.mesh->positions(), expected.mesh->positions()));
    ASSERT_EQ(made.surface.places.size(), 300u);
    for (std::size_t i = 0; i < 300; ++i) EXPECT_EQ(made.surface.places[i].at, expected.places[i].at);
  }
}

TEST_F(SampleChains, ComputeSharedStagesOnce) {
  SampleChain chain(input_, host_, settings_, observer_);
  const PlacedSurface greedy = chain.make(with("greedy")).surface, none = chain.make(with("none")).surface,
                      again = chain.make(with("greedy")).surface;
  ASSERT_EQ(greedy.stages.size(), 4u);
  ASSERT_EQ(none.stages.size(), 4u);
  // Another run would not take the same number of nanoseconds in both stages.
  for (int stage = 0; stage < 2; ++stage) EXPECT_EQ(greedy.stages[stage].seconds, none.stages[stage].seconds);
  EXPECT_EQ(none.stages[2].plugin.full_name(), "decimator_none");
  EXPECT_EQ(greedy.mesh, again.mesh);
}

TEST_F(SampleChains, RememberARefusal) {
  input_.positions.resize(3), input_.element_of_row.resize(3);
  SampleChain chain(input_, host_, settings_, observer_);
  const SurfaceAttempt first = chain.make({}), second = chain.make({});
  ASSERT_TRUE(first.refusal && second.refusal);
  EXPECT_STREQ(first.refusal->what(), second.refusal->what());
  EXPECT_EQ(first.surface.stages.size(), second.surface.stages.size());
}

TEST_F(SampleChains, AnUnknownPluginIsNoRefusal) {
  SampleChain chain(input_, host_, settings_, observer_);
  EXPECT_THROW(chain.make(with("no_such")), OptionError);
  EXPECT_THROW(chain.make(with("no_such")), OptionError);
}

NamedPoint row(Index i) { return {{}, 0, i, std::to_string(i)}; }

TEST_F(SampleChains, PartsHoldTheSourcesAndNest) {
  const std::vector<NamedPoint> sources{row(17), row(250)};
  const SamplePart half = part_of(input_, 150, sources, 9), quarter = part_of(input_, 75, sources, 9);
  EXPECT_GE(half.element.size(), 150u);
  EXPECT_LE(half.element.size(), 152u);
  EXPECT_TRUE(std::ranges::is_sorted(half.element));
  EXPECT_TRUE(std::ranges::includes(half.element, quarter.element));
  for (const Index source : {17u, 250u}) EXPECT_TRUE(std::ranges::binary_search(quarter.element, source));
  for (std::size_t i = 0; i < half.element.size(); ++i)
    EXPECT_EQ(half.input.positions[half.input.element_of_row[i]], input_.positions[half.element[i]]);
}

TEST_F(SampleChains, PartsFindTheSourcesOnTheirOwnSurface) {
  NamedPoint point;
  point.place = {Place::State::on_surface, {}, no_index, {0, 0, 1.5}};
  const std::vector<NamedPoint> sources{row(250), point};
  const SamplePart half = part_of(input_, 150, sources, 9);
  const PlacedSurface surface = SampleChain(half.input, host_, settings_, observer_).make({}).surface;
  const std::vector<NamedPoint> placed = half.place(sources, input_, surface);
  EXPECT_EQ(placed[0].place.position, input_.positions[250]);
  EXPECT_LT(distance(surface.mesh->position(placed[0].place.at), input_.positions[250]), 0.1);
  EXPECT_LT(distance(surface.mesh->position(placed[1].place.at), {0, 0, 1}), 0.2);
}

}  // namespace
}  // namespace geodrome::test
