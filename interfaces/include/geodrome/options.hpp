// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "geodrome/errors.hpp"
#include "geodrome/option_spec.hpp"

namespace geodrome {

/// The checked values of a plugin's options. Immutable after construction; safe to share.
class OptionValues {
 public:
  OptionValues() = default;

  /// Takes "k=30,cap=off"; what is not named has its default. Throws OptionError for an unknown or repeated key and for
  /// a value of the wrong type or out of range, naming what would be valid.
  explicit OptionValues(std::span<const OptionSpec> specs, std::string_view text = {}) {
    for (const OptionSpec& spec : specs) values_[spec.name] = spec.default_value;
    std::map<std::string, bool, std::less<>> given;
    while (!text.empty()) {
      const std::string_view item = text.substr(0, text.find(','));
      text.remove_prefix(std::min(text.size(), item.size() + 1));
      const std::size_t equal = item.find('=');
      const std::string key(item.substr(0, equal));
      const OptionSpec& spec = find(specs, key);
      if (equal == std::string_view::npos)
        throw OptionError("option '" + key + "' has no value", "write " + key + "=VALUE");
      if (!given.emplace(key, true).second) throw OptionError("option '" + key + "' is given twice");
      const std::string value(item.substr(equal + 1));
      check(spec, value);
      values_[key] = value;
    }
  }

  /// Tells whether an option is on. Throws std::invalid_argument if it is neither on nor off. All four accessors throw
  /// std::out_of_range for a name that the plugin did not declare; both are errors in the plugin.
  bool boolean(std::string_view name) const {
    const std::string& value = text(name);
    if (choice_index("on|off", value) == no_choice) throw wrong_type(name, "neither on nor off");
    return value == "on";
  }

  /// A whole number, exact up to 2^53. Of an option that was declared as a number its value is cut towards zero. Throws
  /// std::invalid_argument for a word and for what does not fit the type.
  std::int64_t integer(std::string_view name) const {
    const double value = number(name);
    if (!(std::abs(value) < 9e18)) throw wrong_type(name, "no whole number");
    return static_cast<std::int64_t>(value);
  }

  /// A number, also of an option that was declared as an integer. Throws std::invalid_argument for a word.
  double number(std::string_view name) const {
    const double value = parse(text(name));
    if (std::isnan(value)) throw wrong_type(name, "no number");
    return value;
  }

  /// The value as text, whatever the type: the choice, or the number as the user wrote it.
  const std::string& text(std::string_view name) const {
    const auto found = values_.find(name);
    if (found == values_.end()) throw std::out_of_range("option '" + std::string(name) + "' was never declared");
    return found->second;
  }

  /// All options with their values, in alphabetical order.
  const std::map<std::string, std::string, std::less<>>& all() const noexcept { return values_; }

  /// A bound of an option as a user would write it: 1000000, not 1e+06.
  static std::string shown(double value) {
    char buffer[32];
    const bool plain = value == std::floor(value) && std::abs(value) < 1e15;  // 1000000, not 1e+06
    const auto format = plain ? std::chars_format::fixed : std::chars_format::general;
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr};
  }

 private:
  static const OptionSpec& find(std::span<const OptionSpec> specs, const std::string& key) {
    std::string valid;
    for (const OptionSpec& spec : specs) {
      if (key == spec.name) return spec;
      valid += (valid.empty() ? "" : ", ") + std::string(spec.name);
    }
    throw OptionError("unknown option '" + key + "'",
                      valid.empty() ? "there are no options" : "valid options: " + valid);
  }

  static double parse(const std::string& text) {
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : std::numeric_limits<double>::quiet_NaN();
  }

  std::invalid_argument wrong_type(std::string_view name, const char* what) const {
    return std::invalid_argument("option '" + std::string(name) + "': '" + text(name) + "' is " + what);
  }

  static void check(const OptionSpec& spec, const std::string& value) {
    const std::string what = "option '" + std::string(spec.name) + "': '" + value + "' is not ";
    if (spec.type == OptionType::boolean || spec.type == OptionType::choice) {
      if (choice_index(spec.choices, value) == no_choice) throw OptionError(what + "one of " + spec.choices);
      return;
    }
    const double number = parse(value);
    const bool whole = spec.type == OptionType::integer;
    if (std::isnan(number) || (whole && number != std::floor(number)) || number < spec.minimum || number > spec.maximum)
      throw OptionError(what + (whole ? "a whole number" : "a number") + " from " + shown(spec.minimum) + " to " +
                        shown(spec.maximum));
  }

  std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace geodrome
