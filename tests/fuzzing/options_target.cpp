// SPDX-License-Identifier: MIT
// Texts that choose a plugin and its options.
#include <cmath>

#include "engine/host/plugin_choice.hpp"
#include "geodrome/settings.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {
namespace {

struct Settings {
  int k = 0;
  std::int64_t large = 0;
  double delta = 0, any = 0;
  bool smooth = false;
  std::string rule;
};

constexpr double two_to_53 = 9007199254740992;

constexpr auto options = settings_table(option("k", &Settings::k, "20", 6, 400, "points", "neighbours"),
                                        option("large", &Settings::large, "-7", -two_to_53, two_to_53, "", "whole"),
                                        option("delta", &Settings::delta, "0.1", 1e-3, 1, "", "accuracy"),
                                        option("any", &Settings::any, "0", -std::numeric_limits<double>::infinity(),
                                               std::numeric_limits<double>::infinity(), "", "any number"),
                                        option("smooth", &Settings::smooth, "on", "moves points"),
                                        option("rule", &Settings::rule, "fast", "fast|exact|", "the rule"));

std::string text_of(const OptionValues& values) {
  std::string text;
  for (const auto& [name, value] : values.all()) text += (text.empty() ? "" : ",") + name + "=" + value;
  return text;
}

void check_choice(const std::string& text) {
  const PluginChoice choice = parse_choice("solver", text);
  demand(text.ends_with(choice.options), "the options are the end of the text");
  demand(choice.file.empty() || choice.name.empty(), "a choice is a name or a file");
  demand(choice.file.empty() || choice.file.is_absolute(), "a file is known by its whole path");
}

}  // namespace

void check_options(std::string_view input) {
  const std::string text(input);
  if (text.find('\0') == text.npos) check_choice(text);
  try {
    const OptionValues values(options, text);
    const Settings settings = options.parsed(values);
    demand(settings.k >= 6 && settings.k <= 400, "whole numbers are in range");
    demand(std::abs(static_cast<double>(settings.large)) <= two_to_53, "large whole numbers are in range");
    demand(settings.delta >= 1e-3 && settings.delta <= 1 && !std::isnan(settings.any), "numbers are in range");
    demand(choice_index("fast|exact|", settings.rule) != no_choice, "a choice is one of the words");
    demand(OptionValues(options, text_of(values)).all() == values.all(), "options that are written read back");
  } catch (const OptionError& error) {
    demand(!error.message().empty(), "a refusal says why");
  }
}

std::vector<std::string> option_seeds() {
  return {"",
          "k=30,smooth=off",
          "large=9007199254740992,any=-inf,rule=",
          "delta=1e-3,rule=exact,k=6.0",
          "k=7,k=8,",
          "=1,k",
          "solver_heat:k=20",
          "./folder/solver_own.so:delta=0.5",
          "any=nan,large=1e300,smooth=maybe"};
}

}  // namespace geodrome::fuzzing
