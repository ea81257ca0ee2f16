// SPDX-License-Identifier: MIT
#include "engine/formats/remedies.hpp"

#include <gtest/gtest.h>

namespace geodrome {
namespace {

TEST(Remedies, HoldTheirCodeTheirParametersAndTheSentenceWithThem) {
  const Remedy remedy = remedies::start_anew("remove it");
  EXPECT_EQ(remedy.code, "resume.anew");
  EXPECT_EQ(remedy.parameters, std::vector<std::string>{"remove it"});
  EXPECT_EQ(remedy.text, "remove it, or leave `resume` out to start anew");
}

TEST(Remedies, OfPairsNameTheSolversThatThereAre) {
  EXPECT_EQ(remedies::solver_of_pairs("a, b").code, "solver.pairs");
  EXPECT_NE(remedies::solver_of_pairs("a, b").text.find("(a, b)"), std::string::npos);
  EXPECT_EQ(remedies::solver_of_pairs("").code, "solver.no_pairs");
}

TEST(Remedies, SentencesAreFilledPlaceByPlace) {
  const std::vector<std::string> two{"x", "y"};
  EXPECT_EQ(filled("{1} before {0}, {2}", two), "y before x, {2}");
  EXPECT_EQ(filled("no place", two), "no place");
}

TEST(Remedies, AnErrorIsSaidInTheWordsGiven) {
  OptionError error("it is wrong", remedies::weld());
  EXPECT_EQ(text_of(error, "press W"), "it is wrong; press W");
  error.attribute_to("solver_x");
  EXPECT_EQ(text_of(error, error.remedy()), error.what());
  EXPECT_EQ(text_of(error, ""), "solver_x: it is wrong");
}

}  // namespace
}  // namespace geodrome
