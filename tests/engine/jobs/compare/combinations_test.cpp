// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/combinations.hpp"

#include <gtest/gtest.h>

namespace geodrome {
namespace {

using Choices = std::vector<std::string>;

std::vector<std::string> names(const std::vector<std::string>& stages, InputKind kind, const StageChoice& fixed = {}) {
  std::vector<VariedStage> varied;
  for (const std::string& text : stages) varied.push_back(parse_varied_stage(text));
  std::vector<std::string> result;
  for (const Combination& combination : combinations_of(varied, fixed, kind)) result.push_back(combination.name);
  return result;
}

void expect_refused(const std::vector<std::string>& stages, InputKind kind, const std::string& word,
                    const StageChoice& fixed = {}) {
  try {
    names(stages, kind, fixed);
    ADD_FAILURE() << "was taken: " << stages.front();
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    EXPECT_FALSE(error.remedy().empty()) << error.what();
  }
}

TEST(VariedStage, SeparatesChoicesFromTheirOptions) {
  EXPECT_EQ(parse_varied_stage("solver=cgal,chen_han").choices, (Choices{"cgal", "chen_han"}));
  EXPECT_EQ(parse_varied_stage("solver=a:k=1,b:j=2,i=3,c").choices, (Choices{"a:k=1", "b:j=2,i=3", "c"}));
  EXPECT_EQ(parse_varied_stage("tangent=jet").stage, "tangent");
}

TEST(VariedStage, RefusesWhatNamesNothing) {
  for (const char* text : {"solver", "solver=", "=cgal", "solvers=cgal", "solver=,cgal", "solver=cgal,,chen_han",
                           "solver=k=1", "solver=cgal,cgal"})
    expect_refused({text}, InputKind::mesh, "stage");
}

TEST(Combinations, AreTheProductWithTheLastStageFastest) {
  EXPECT_EQ(names({"reconstructor=r,s", "solver=a,b:k=1,j=2"}, InputKind::points),
            (Choices{"r, a", "r, b:k=1,j=2", "s, a", "s, b:k=1,j=2"}));
}

TEST(Combinations, ChooseTheVariedStagesAndLeaveTheOthers) {
  StageChoice fixed;
  fixed.tangent = "pole";
  const std::vector<VariedStage> varied{parse_varied_stage("decimator=none,greedy"), parse_varied_stage("solver=x")};
  const auto all = combinations_of(varied, fixed, InputKind::points);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "none, x");
  EXPECT_EQ(all[0].choice.decimator, "none");
  EXPECT_EQ(all[0].choice.tangent, "pole");
  EXPECT_EQ(all[0].choice.control, StageChoice().control);
  EXPECT_EQ(all[1].choice.decimator, "greedy");
  EXPECT_EQ(all[1].choice.solver, "x");
}

TEST(Combinations, OfNoVariedStageIsTheOneThatIsChosen) {
  StageChoice fixed;
  fixed.solver = "cgal";
  EXPECT_EQ(names({}, InputKind::mesh, fixed), Choices{"cgal"});
}

TEST(Combinations, RefuseContradictions) {
  expect_refused({"solver=a", "solver=b"}, InputKind::mesh, "twice");
  expect_refused({"tangent=jet,pca"}, InputKind::mesh, "mesh");
  StageChoice fixed;
  fixed.solver = "cgal";
  expect_refused({"solver=a,b"}, InputKind::mesh, "the solver is both chosen and varied", fixed);
}

TEST(Combinations, OfAMeshTellTheSolverAlone) {
  EXPECT_EQ(choices_by_stage({}, InputKind::mesh).size(), 1u);
  const auto all = choices_by_stage({}, InputKind::points);
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all.front().first, "tangent");
  EXPECT_EQ(all.back(), (std::pair<std::string, std::string>("solver", StageChoice().solver)));
}

}  // namespace
}  // namespace geodrome
