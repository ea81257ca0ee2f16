// SPDX-License-Identifier: MIT
#include "tools/geodrome/remedies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace geodrome::cli {
namespace {

/// The sentence of a code in a table; empty if there is none.
std::string_view sentence_of(std::span<const RemedySentence> table, std::string_view code) {
  const auto found = std::ranges::find(table, code, &RemedySentence::code);
  return found == table.end() ? std::string_view() : found->sentence;
}

TEST(Remedies, EveryOneThatNamesAMemberHasWordsOfTheCommandLine) {
  for (const RemedySentence& remedy : remedy_sentences()) {
    const bool names_one = remedy.sentence.find('`') != remedy.sentence.npos;
    EXPECT_EQ(names_one, !sentence_of(sentences_of_flags(), remedy.code).empty()) << remedy.code;
  }
}

TEST(Remedies, TheCommandLineKnowsNoCodeThatTheEngineDoesNotGive) {
  for (const RemedySentence& remedy : sentences_of_flags())
    EXPECT_FALSE(sentence_of(remedy_sentences(), remedy.code).empty()) << remedy.code;
}

TEST(Remedies, CodesAreUniqueAndTheirSentencesTakeTheSameParameters) {
  std::set<std::string_view> codes;
  for (const RemedySentence& remedy : remedy_sentences()) {
    EXPECT_TRUE(codes.insert(remedy.code).second) << remedy.code;
    const std::string_view flags = sentence_of(sentences_of_flags(), remedy.code);
    EXPECT_EQ(remedy.sentence.find("{0}") == remedy.sentence.npos, flags.find("{0}") == flags.npos) << remedy.code;
    EXPECT_EQ(remedy.sentence.find("{1}"), remedy.sentence.npos) << remedy.code;
  }
}

TEST(Remedies, TheLibraryNamesNoFlagAndTheCommandLineNoMember) {
  for (const RemedySentence& remedy : remedy_sentences())
    EXPECT_EQ(remedy.sentence.find("--"), remedy.sentence.npos) << remedy.code;
  for (const RemedySentence& remedy : sentences_of_flags())
    EXPECT_EQ(remedy.sentence.find('`'), remedy.sentence.npos) << remedy.code;
}

TEST(Remedies, ParametersStandInTheSentence) {
  EXPECT_EQ(words(Remedy("read.weights", {"density"}, "set `read.weights`")),
            "--weights property:density measures with it");
}

TEST(Remedies, WithoutAKnownCodeTheSentenceOfTheLibraryIsSaid) {
  EXPECT_EQ(words("thin it out"), "thin it out");
  EXPECT_EQ(words(Remedy("a.plugins.own", {}, "thin it out")), "thin it out");
}

TEST(Remedies, AnErrorIsSaidWithItsPluginAndTheFlag) {
  RefusedError error("D.npy would take 6 GB", Remedy("consent", {}, "set `yes`"));
  error.attribute_to("solver_x");
  EXPECT_EQ(text_of(error),
            "solver_x: D.npy would take 6 GB; say --yes, ask for fewer sources or targets, or store float32");
  EXPECT_STREQ(error.what(), "solver_x: D.npy would take 6 GB; set `yes`");
  EXPECT_EQ(text_of(OptionError("it is wrong")), "it is wrong");
}

}  // namespace
}  // namespace geodrome::cli
