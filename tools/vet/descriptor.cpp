// SPDX-License-Identifier: MIT
#include "tools/vet/descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "geodrome/plugin.hpp"

namespace geodrome {
namespace {

std::string text(const char* value, const std::string& what) {
  if (value == nullptr) throw PluginError(what + " is missing");
  return value;
}

void check_name(const std::string& name, const std::string& what) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), allowed))
    throw PluginError(what + " '" + name + "' is not made of a-z, 0-9 and _");
}

void check_stage(const std::string& stage) {
  for (const char* known : {TangentEstimator::stage, ControlFunction::stage, Decimator::stage,
                            SurfaceReconstructor::stage, ShortestPathSolver::stage})
    if (stage == known) return;
  throw PluginError("its stage '" + stage + "' is none of tangent, control, decimator, reconstructor, solver");
}

bool has_comma(const std::string& value) { return value.find(',') != value.npos; }

constexpr double largest_whole = 9007199254740992;  // 2^53

OptionInfo option_info(const OptionSpec& spec) {
  OptionInfo info;
  info.name = text(spec.name, "the name of an option");
  check_name(info.name, "the option name");
  const std::string what = "option '" + info.name + "': ";
  info.type = spec.type;
  if (spec.type > OptionType::choice) throw PluginError(what + "unknown type");
  info.default_value = text(spec.default_value, what + "the default");
  info.minimum = spec.minimum, info.maximum = spec.maximum;
  if (!(spec.minimum <= spec.maximum)) throw PluginError(what + "the range is empty");
  const bool whole = spec.type == OptionType::integer;
  if (whole && (spec.minimum < -largest_whole || spec.maximum > largest_whole))
    throw PluginError(what + "whole numbers beyond 2^53 are not exact");
  info.choices = text(spec.choices, what + "the list of choices");
  if (spec.type == OptionType::boolean && info.choices != "on|off")
    throw PluginError(what + "is on or off, nothing else");
  if (has_comma(info.default_value) || (spec.type == OptionType::choice && has_comma(info.choices)))
    throw PluginError(what + "a value with a comma cannot be written, since a comma ends an option");
  info.unit = text(spec.unit, what + "the unit");
  info.help = text(spec.help, what + "the help");
  return info;
}

/// The options, each checked against its own default by the very code that checks what a user writes.
std::vector<OptionInfo> option_infos(std::span<const OptionSpec> specs) {
  std::vector<OptionInfo> infos;
  std::set<std::string> names;
  for (const OptionSpec& spec : specs) {
    infos.push_back(option_info(spec));
    if (!names.insert(infos.back().name).second)
      throw PluginError("option '" + infos.back().name + "' is declared twice");
    try {
      OptionValues({&spec, 1}, infos.back().name + "=" + infos.back().default_value);
    } catch (const OptionError& error) {
      throw PluginError("the default does not pass its own check: " + std::string(error.what()));
    }
  }
  return infos;
}

double default_factor(const PluginDescriptor& plugin, std::span<const OptionSpec> specs) {
  const OptionValues defaults(specs);
  const double factor = plugin.factor(&defaults);
  if (!(factor >= 1)) throw PluginError("its factor " + OptionValues::shown(factor) + " is below 1 or no number");
  return factor;
}

}  // namespace

PluginInfo checked_info(const PluginDescriptor& plugin) {
  PluginInfo info;
  info.stage = text(plugin.stage, "its stage");
  check_stage(info.stage);
  info.name = text(plugin.name, "its name");
  check_name(info.name, "its name");
  info.summary = text(plugin.summary, "its summary");
  info.licence = text(plugin.licence, "its licence");
  info.needs = plugin.needs, info.provides = plugin.provides;
  if (unknown_bits(plugin.needs) != Needs::nothing) throw PluginError("it needs something this host does not know");
  if (unknown_bits(plugin.provides) != Provides::nothing)
    throw PluginError("it provides something this host does not know");
  if (!plugin.factor || !plugin.create || !plugin.destroy) throw PluginError("its descriptor lacks a function");
  if (plugin.extension && plugin.extension("no such extension") != nullptr)
    throw PluginError("it offers an extension that does not exist");
  if (plugin.options == nullptr && plugin.option_count > 0) throw PluginError("its options are missing");
  const std::span specs(plugin.options, plugin.option_count);
  info.options = option_infos(specs);
  info.default_factor = default_factor(plugin, specs);
  if (std::isfinite(info.default_factor)) info.provides |= Provides::never_shorter;
  return info;
}

}  // namespace geodrome
