// SPDX-License-Identifier: MIT
#include "geodrome/settings.hpp"

#include <gtest/gtest.h>

namespace geodrome {
namespace {

enum class Rule { fast, exact };

struct Settings {
  std::size_t k;
  double delta;
  bool cap;
  Rule rule;
  bool thin;
  std::string word;
  int unbound = 7;
};

constexpr auto options = settings_table(
    option("k", &Settings::k, "20", 6, 400, "points", "neighbours"),
    option("delta", &Settings::delta, "0.05", 0, std::numeric_limits<double>::infinity(), "", "a tolerance"),
    option("cap", &Settings::cap, "on", "limits phi"),
    option("rule", &Settings::rule, "exact", "fast|exact", {Rule::fast, Rule::exact}, "a rule"),
    option("shape", &Settings::thin, "thin", "thin|thick", {true, false}, "a shape"),
    option("word", &Settings::word, "left", "left|right", "a side"));

Settings settings(std::string_view text) { return options.parsed(OptionValues(options, text)); }

TEST(Settings, HaveTheDefaultsOfTheirOptions) {
  const Settings is = settings("");
  EXPECT_EQ(is.k, 20u);
  EXPECT_EQ(is.delta, 0.05);
  EXPECT_TRUE(is.cap);
  EXPECT_EQ(is.rule, Rule::exact);
  EXPECT_TRUE(is.thin);
  EXPECT_EQ(is.word, "left");
  EXPECT_EQ(is.unbound, 7) << "no option is bound to it";
}

TEST(Settings, TakeWhatTheUserWrites) {
  const Settings is = settings("k=6,delta=1e-3,cap=off,rule=fast,shape=thick,word=right");
  EXPECT_EQ(is.k, 6u);
  EXPECT_EQ(is.delta, 1e-3);
  EXPECT_FALSE(is.cap);
  EXPECT_EQ(is.rule, Rule::fast);
  EXPECT_FALSE(is.thin);
  EXPECT_EQ(is.word, "right");
}

TEST(Settings, AreCheckedAsTheirOptionsAre) {
  EXPECT_THROW(settings("k=5"), OptionError);
  EXPECT_THROW(settings("k=6.5"), OptionError);
  EXPECT_THROW(settings("rule=slow"), OptionError);
}

TEST(Settings, StateTheirOptionsInOrder) {
  const std::span<const OptionSpec> specs = options;
  ASSERT_EQ(specs.size(), 6u);
  EXPECT_STREQ(specs[0].name, "k");
  EXPECT_EQ(specs[0].type, OptionType::integer);
  EXPECT_EQ(specs[0].maximum, 400);
  EXPECT_STREQ(specs[0].unit, "points");
  EXPECT_EQ(specs[1].type, OptionType::number);
  EXPECT_EQ(specs[2].type, OptionType::boolean);
  EXPECT_EQ(specs[3].type, OptionType::choice);
  EXPECT_STREQ(specs[4].choices, "thin|thick");
  EXPECT_STREQ(specs[5].default_value, "left");
}

}  // namespace
}  // namespace geodrome
