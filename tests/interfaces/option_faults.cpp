// SPDX-License-Identifier: MIT
// Compiles unless one of the faults is asked for.
#include "geodrome/settings.hpp"

using namespace geodrome;

enum class Rule { fast, exact };

struct Settings {
  unsigned char k;
  bool on;
  Rule rule;
};

constexpr auto right = settings_table(
    option("k", &Settings::k, "20", 0, 255, "points", "a help"), option("on", &Settings::on, "off", "a help"),
    option("rule", &Settings::rule, "fast", "fast|exact", {Rule::fast, Rule::exact}, "a help"));
#ifdef WRONG_TYPE
constexpr auto wrong = settings_table(option("on", &Settings::on, "1", 0, 1, "", "a help"));
#endif
#ifdef NO_NUMBER
constexpr auto wrong = settings_table(option("k", &Settings::k, "2.5", 0, 255, "points", "a help"));
#endif
#ifdef NO_CHOICE
constexpr auto wrong = settings_table(option("on", &Settings::on, "yes", "a help"));
#endif
#ifdef CHOICE_WITH_COMMA
constexpr auto wrong =
    settings_table(option("rule", &Settings::rule, "fast", "fast|slow,exact", {Rule::fast, Rule::exact}, "a help"));
#endif
#ifdef TOO_SMALL_A_MEMBER
constexpr auto wrong = settings_table(option("k", &Settings::k, "20", 0, 256, "points", "a help"));
#endif
#ifdef TOO_FEW_VALUES
constexpr auto wrong =
    settings_table(option("rule", &Settings::rule, "fast", "fast|exact|both", {Rule::fast, Rule::exact}, "a help"));
#endif
