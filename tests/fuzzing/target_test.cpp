// SPDX-License-Identifier: MIT
#include "tests/fuzzing/target.hpp"

#include <gtest/gtest.h>

namespace geodrome::fuzzing {
namespace {

constexpr const char* three_lines = "a\nb\nc";

void judge(const std::string& message) {
  demand_clear(InputError(InputFault::syntax, message, "write it again"), "m.obj", three_lines);
}

TEST(DemandClear, TakesALineThatIsThere) {
  EXPECT_NO_THROW(judge("m.obj: line 3: 'x' is no number"));
  EXPECT_NO_THROW(judge("m.obj: has no faces"));
}

TEST(DemandClear, RefusesALineThatIsNotThere) {
  EXPECT_THROW(judge("m.obj: line 4: 'x' is no number"), Broken);
  EXPECT_THROW(judge("m.obj: line 0: 'x' is no number"), Broken);
  EXPECT_THROW(judge("m.obj: line x: 'x' is no number"), Broken);
}

/// libFuzzer writes what a target looks for into the file.
TEST(DemandClear, TakesWordsThatAMessageQuotesForNoLine) {
  EXPECT_NO_THROW(judge("m.obj: its entries are '<f4m.obj: line ', not '<f8' or '<f4'"));
  EXPECT_NO_THROW(judge("m.obj: line 2: 'm.obj: line 9' is no number"));
}

TEST(DemandClear, RefusesWhatIsUnfitToShow) {
  EXPECT_THROW(judge("has no faces"), Broken);
  EXPECT_THROW(judge("m.obj: '\033[2J' is no number"), Broken);
  EXPECT_THROW(judge("m.obj: " + std::string(1000, 'x')), Broken);
}

}  // namespace
}  // namespace geodrome::fuzzing
