// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>

#include "geodrome/options.hpp"

/// Options bound to the members of a plain struct where they are declared, so that a plugin never names one twice:
///
///     struct JetSettings {
///       std::size_t k;
///       bool smooth;
///       Rule rule;
///     };
///     inline constexpr auto jet_options = settings_table(
///         option("k", &JetSettings::k, "20", 6, 400, "points", "neighbours that the quadric is fitted to"),
///         option("smooth", &JetSettings::smooth, "on", "moves points onto the surface"),
///         option("rule", &JetSettings::rule, "fast", "fast|exact", {Rule::fast, Rule::exact}, "what is dropped"));
///
/// GEODROME_PLUGIN takes the table as `.options`; `jet_options.parsed(values)` makes the struct. The member decides the
/// type of the option; a default, range or list of values that does not fit it does not compile.
namespace geodrome {

/// An option and the member that takes its value. `values`: of a choice whose member is no string, one per word.
template <class Settings, class Member, std::size_t ValueCount = 0>
struct BoundOption {
  OptionSpec spec;
  Member Settings::*member;
  std::array<Member, ValueCount> values;

  /// Gives the member the value of this option. Thread-safe.
  void set(Settings& settings, const OptionValues& given) const {
    if constexpr (ValueCount > 0)
      settings.*member = values[choice_index(spec.choices, given.text(spec.name))];
    else if constexpr (std::same_as<Member, std::string>)
      settings.*member = given.text(spec.name);
    else if constexpr (std::same_as<Member, bool>)
      settings.*member = given.boolean(spec.name);
    else if constexpr (std::integral<Member>)
      settings.*member = static_cast<Member>(given.integer(spec.name));
    else
      settings.*member = static_cast<Member>(given.number(spec.name));
  }
};

namespace detail {

/// Called where a declaration is wrong: it is no constant expression, so that its argument is the compiler's message.
inline void declaration_error(const char*) {}

consteval void check_choice(std::string_view choices, std::string_view default_value) {
  if (choices.find(',') != std::string_view::npos) declaration_error("a comma ends an option, so no choice has one");
  if (choice_index(choices, default_value) == no_choice) declaration_error("the default is none of the choices");
}

/// `whole`: digits alone.
consteval void check_number(std::string_view default_value, bool whole) {
  const std::string_view allowed = whole ? "-0123456789" : "-0123456789.e";
  if (default_value.empty() || default_value.find_first_not_of(allowed) != std::string_view::npos)
    declaration_error("the default is no number of the member's type");
}

}  // namespace detail

/// A real number. Range, unit and help are those of `number_option`.
template <class Settings, std::floating_point Member>
consteval auto option(const char* name, Member Settings::*member, const char* default_value, double minimum,
                      double maximum, const char* unit, const char* help) {
  detail::check_number(default_value, false);
  return BoundOption<Settings, Member>{number_option(name, default_value, minimum, maximum, unit, help), member, {}};
}

/// A whole number; the member must be able to hold the range.
template <class Settings, std::integral Member>
requires(!std::same_as<Member, bool>) consteval auto option(const char* name, Member Settings::*member,
                                                            const char* default_value, double minimum, double maximum,
                                                            const char* unit, const char* help) {
  using Limits = std::numeric_limits<Member>;
  detail::check_number(default_value, true);
  if (minimum < static_cast<double>(Limits::lowest()) || maximum > static_cast<double>(Limits::max()))
    detail::declaration_error("the member cannot hold the range");
  return BoundOption<Settings, Member>{integer_option(name, default_value, minimum, maximum, unit, help), member, {}};
}

/// On or off.
template <class Settings>
consteval auto option(const char* name, bool Settings::*member, const char* default_value, const char* help) {
  detail::check_choice("on|off", default_value);
  return BoundOption<Settings, bool>{boolean_option(name, default_value, help), member, {}};
}

/// One of several words, kept as the word.
template <class Settings>
consteval auto option(const char* name, std::string Settings::*member, const char* default_value, const char* choices,
                      const char* help) {
  detail::check_choice(choices, default_value);
  return BoundOption<Settings, std::string>{choice_option(name, default_value, choices, help), member, {}};
}

/// One of several words, kept as the value at its place in `values`.
template <class Settings, class Member, std::size_t Count>
consteval auto option(const char* name, Member Settings::*member, const char* default_value, const char* choices,
                      const std::type_identity_t<Member> (&values)[Count], const char* help) {
  detail::check_choice(choices, default_value);
  if (choice_count(choices) != Count) detail::declaration_error("there must be one value for each choice");
  return BoundOption<Settings, Member, Count>{choice_option(name, default_value, choices, help), member,
                                              std::to_array(values)};
}

/// All options of a plugin, in the order in which they are shown. Made by `settings_table`.
template <class Settings, class... Bound>
class SettingsTable {
 public:
  consteval explicit SettingsTable(Bound... options) : bound_(options...), specs_{options.spec...} {}

  constexpr operator std::span<const OptionSpec>() const noexcept { return specs_; }  // NOLINT: it is these options

  /// The struct that `values`, made with the options of this table, says. Members that no option is bound to have their
  /// default. Thread-safe.
  Settings parsed(const OptionValues& values) const {
    Settings settings{};
    std::apply([&](const auto&... option) { (option.set(settings, values), ...); }, bound_);
    return settings;
  }

 private:
  std::tuple<Bound...> bound_;
  std::array<OptionSpec, sizeof...(Bound)> specs_;
};

/// Puts options of one struct together. Evaluated by the compiler.
template <class Settings, class... Members, std::size_t... Counts>
consteval auto settings_table(BoundOption<Settings, Members, Counts>... options) {
  return SettingsTable<Settings, BoundOption<Settings, Members, Counts>...>(options...);
}

}  // namespace geodrome
