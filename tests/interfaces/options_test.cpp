// SPDX-License-Identifier: MIT
#include "geodrome/options.hpp"

#include <gtest/gtest.h>

namespace geodrome {
namespace {

constexpr OptionSpec specs[] = {boolean_option("cap", "on", ""), integer_option("k", "3", 1, 9, "", ""),
                                number_option("delta", "2.75", 0, 9, "", ""),
                                choice_option("smooth", "auto", "auto|on|off", "")};

TEST(OptionValues, ANumberIsCutTowardsZeroAsAnInteger) {
  EXPECT_EQ(OptionValues(specs).integer("delta"), 2);
  EXPECT_EQ(OptionValues(specs).number("k"), 3);
}

TEST(OptionValues, AWordIsNoNumberAndOnlyOnAndOffAreBoolean) {
  const OptionValues values(specs);
  EXPECT_THROW(values.number("smooth"), std::invalid_argument);
  EXPECT_THROW(values.integer("cap"), std::invalid_argument);
  EXPECT_THROW(values.boolean("smooth"), std::invalid_argument);
  EXPECT_THROW(values.boolean("k"), std::invalid_argument);
  EXPECT_TRUE(values.boolean("cap"));
  EXPECT_FALSE(OptionValues(specs, "smooth=off").boolean("smooth"));
}

TEST(OptionValues, AnOptionThatWasNotDeclaredIsAnErrorOfThePlugin) {
  EXPECT_THROW(OptionValues(specs).text("l"), std::out_of_range);
}

TEST(OptionValues, AChoiceIsOneWholeWord) {
  for (const char* text : {"smooth=o", "smooth=on|off", "smooth=", "smooth=|", "smooth=auto|"})
    EXPECT_THROW(OptionValues(specs, text), OptionError) << text;
}

TEST(Choices, AreCountedAndFound) {
  EXPECT_EQ(choice_count("auto|on|off"), 3u);
  EXPECT_EQ(choice_index("auto|on|off", "auto"), 0u);
  EXPECT_EQ(choice_index("auto|on|off", "off"), 2u);
  EXPECT_EQ(choice_index("auto|on|off", "o"), no_choice);
  EXPECT_EQ(choice_index("auto|on|off", "on|off"), no_choice);
}

}  // namespace
}  // namespace geodrome
