// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "geodrome/engine/plugin_info.hpp"
#include "geodrome/geometry.hpp"

/// The JSON by which `geodrome-vet` tells the host what a plugin is. Infinity, which JSON has not, is written as "inf"
/// and "-inf".
namespace geodrome {

inline nlohmann::json json_number(double value) {
  if (std::isfinite(value)) return value;
  return value > 0 ? "inf" : "-inf";
}

/// Throws nlohmann's exceptions for what `json_number` did not write.
inline double number_from_json(const nlohmann::json& json) {
  if (json.is_number()) return json.get<double>();
  const auto sign = nlohmann::json{{"inf", 1}, {"-inf", -1}}.at(json.get<std::string>()).get<int>();
  return sign * infinity;
}

/// Throws nlohmann's exceptions for what is no whole number >= 0, which a cast would turn into one.
inline std::uint64_t whole_from_json(const nlohmann::json& json) {
  return json.get_ref<const nlohmann::json::number_unsigned_t&>();
}

/// Throws nlohmann's exceptions for a number that is none of the types.
inline OptionType type_from_json(const nlohmann::json& json) {
  static const nlohmann::json types{OptionType::boolean, OptionType::integer, OptionType::number, OptionType::choice};
  return types.at(whole_from_json(json)).get<OptionType>();
}

inline void to_json(nlohmann::json& json, const OptionInfo& option) {
  json = {{"name", option.name},
          {"type", static_cast<std::uint32_t>(option.type)},
          {"default", option.default_value},
          {"minimum", json_number(option.minimum)},
          {"maximum", json_number(option.maximum)},
          {"choices", option.choices},
          {"unit", option.unit},
          {"help", option.help}};
}

inline void from_json(const nlohmann::json& json, OptionInfo& option) {
  json.at("name").get_to(option.name);
  option.type = type_from_json(json.at("type"));
  json.at("default").get_to(option.default_value);
  option.minimum = number_from_json(json.at("minimum"));
  option.maximum = number_from_json(json.at("maximum"));
  json.at("choices").get_to(option.choices);
  json.at("unit").get_to(option.unit);
  json.at("help").get_to(option.help);
}

/// Everything but `file`, which the host knows.
inline void to_json(nlohmann::json& json, const PluginInfo& plugin) {
  json = {{"stage", plugin.stage},
          {"name", plugin.name},
          {"summary", plugin.summary},
          {"licence", plugin.licence},
          {"needs", static_cast<std::uint64_t>(plugin.needs)},
          {"provides", static_cast<std::uint64_t>(plugin.provides)},
          {"default_factor", json_number(plugin.default_factor)},
          {"options", plugin.options}};
}

inline void from_json(const nlohmann::json& json, PluginInfo& plugin) {
  json.at("stage").get_to(plugin.stage);
  json.at("name").get_to(plugin.name);
  json.at("summary").get_to(plugin.summary);
  json.at("licence").get_to(plugin.licence);
  plugin.needs = Needs{whole_from_json(json.at("needs"))};
  plugin.provides = Provides{whole_from_json(json.at("provides"))};
  plugin.default_factor = number_from_json(json.at("default_factor"));
  json.at("options").get_to(plugin.options);
}

}  // namespace geodrome
