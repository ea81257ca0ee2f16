// SPDX-License-Identifier: MIT
#include "geodrome/engine/accuracy.hpp"

#include <gtest/gtest.h>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {
namespace {

std::string refusal(const std::string& accuracy, Asked asked = Asked::searches) {
  try {
    return "taken: " + solver_of_accuracy(accuracy, asked);
  } catch (const OptionError& error) {
    return error.what();
  }
}

TEST(Accuracy, ChoosesTheSolver) {
  EXPECT_EQ(solver_of_accuracy("exact"), StageChoice().solver);
  EXPECT_EQ(solver_of_accuracy("1e-3"), "merged_windows:delta=0.001");
  EXPECT_EQ(solver_of_accuracy("0.25"), "merged_windows:delta=0.25");
  EXPECT_EQ(solver_of_accuracy("1"), "merged_windows:delta=1");
  EXPECT_EQ(solver_of_accuracy("0.000001"), "merged_windows:delta=1e-06");
}

TEST(Accuracy, OfPairsChoosesAnOracle) {
  EXPECT_EQ(solver_of_accuracy("0.1", Asked::pairs), "aleksandrov:delta=0.1");
  EXPECT_EQ(solver_of_accuracy("1e-4", Asked::pairs), "aleksandrov:delta=1e-04");
}

TEST(Accuracy, IsRefusedByItsRange) {
  for (const char* text : {"", "0", "9e-7", "1.0001", "-1e-3", "nan", "inf", "1e-3x", "Exact", "1e-3,value=middle"})
    EXPECT_EQ(refusal(text), "the accuracy '" + std::string(text) +
                                 "' is none; say exact, or name a number from 1e-06 to 1: distances are at most that "
                                 "share too long");
  EXPECT_EQ(refusal("1e-5", Asked::pairs),
            "the accuracy '1e-5' is none of a pair oracle; name a number from 1e-04 to 1: distances are at most that "
            "share too long");
  EXPECT_EQ(refusal("exact", Asked::pairs),
            "no pair oracle is exact; name a number from 1e-04 on, or ask for rows of distances");
}

TEST(Accuracy, IsWhatTheSolverStates) {
  const PluginHost host;
  EXPECT_EQ(host.load<ShortestPathSolver>(solver_of_accuracy("exact")).factor, 1);
  for (const char* delta : {"1e-6", "0.003", "1"})
    EXPECT_EQ(host.load<ShortestPathSolver>(solver_of_accuracy(delta)).factor, 1 + std::stod(delta));
  for (const char* delta : {"1e-4", "1"})
    EXPECT_EQ(host.load<ShortestPathSolver>(solver_of_accuracy(delta, Asked::pairs)).factor, 1 + std::stod(delta));
}

/// A finite factor implies that no distance is too short; with options that give it up, so goes the promise.
TEST(PluginHost, TellsWhatIsPromisedWithTheOptionsThatWereChosen) {
  const PluginHost host;
  const auto upper = host.load<ShortestPathSolver>("merged_windows");
  const auto middle = host.load<ShortestPathSolver>("merged_windows:value=middle");
  EXPECT_TRUE(has(upper.info.provides, Provides::never_shorter));
  EXPECT_FALSE(has(middle.info.provides, Provides::never_shorter));
  EXPECT_EQ(middle.factor, std::numeric_limits<double>::infinity());
  EXPECT_EQ(upper.info.provides, middle.info.provides | Provides::never_shorter);
}

}  // namespace
}  // namespace geodrome
