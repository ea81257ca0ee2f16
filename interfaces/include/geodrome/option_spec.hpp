// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geodrome {

/// The type of an option: on or off, a whole number, a real number, one of several words.
enum class OptionType : std::uint32_t { boolean, integer, number, choice };

/// One option of a plugin, declared once: help, validation, `plugins show` and the run report derive from it. No value
/// has a comma, which ends an option where a user writes several.
/// Plain data, since it is read across the border to a plugin that may turn out to be incompatible.
struct OptionSpec {
  const char* name;
  OptionType type;
  const char* default_value;  ///< as a user would write it
  double minimum, maximum;    ///< both allowed; integer and number only
  const char* choices;        ///< "on|off"; choice only
  const char* unit;           ///< "" where there is none
  const char* help;
};

/// An option that is "on" or "off"; `default_value` is one of these.
constexpr OptionSpec boolean_option(const char* name, const char* default_value, const char* help) {
  return {name, OptionType::boolean, default_value, 0, 0, "on|off", "", help};
}
/// A whole number from `minimum` to `maximum`, both allowed and below 2^53 in size.
constexpr OptionSpec integer_option(const char* name, const char* default_value, double minimum, double maximum,
                                    const char* unit, const char* help) {
  return {name, OptionType::integer, default_value, minimum, maximum, "", unit, help};
}
/// A real number from `minimum` to `maximum`, both allowed; either may be infinite.
constexpr OptionSpec number_option(const char* name, const char* default_value, double minimum, double maximum,
                                   const char* unit, const char* help) {
  return {name, OptionType::number, default_value, minimum, maximum, "", unit, help};
}
/// One of the words of `choices`, which are separated by '|'.
constexpr OptionSpec choice_option(const char* name, const char* default_value, const char* choices, const char* help) {
  return {name, OptionType::choice, default_value, 0, 0, choices, "", help};
}

/// "It is none of the choices."
inline constexpr std::size_t no_choice = std::string_view::npos;

/// Returns the number of words in `choices`.
constexpr std::size_t choice_count(std::string_view choices) {
  std::size_t count = 1;
  for (const char c : choices) count += c == '|';
  return count;
}

/// The place of `word` among the words of `choices`, from 0; no_choice if it is none of them.
constexpr std::size_t choice_index(std::string_view choices, std::string_view word) {
  for (std::size_t i = 0;; ++i) {
    const std::size_t end = choices.find('|');
    if (choices.substr(0, end) == word) return i;
    if (end == std::string_view::npos) return no_choice;
    choices.remove_prefix(end + 1);
  }
}

}  // namespace geodrome
