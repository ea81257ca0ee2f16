// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/engine/plugin_text.hpp"
#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

struct PluginArguments {
  std::vector<std::filesystem::path> plugin_path;
  std::string name;
  bool json = false;
};

std::string joined_or_nothing(const std::vector<std::string>& words) {
  return words.empty() ? "nothing" : joined(words);
}

std::string guarantee(double factor) {
  if (factor == 1) return "exact";
  if (std::isinf(factor)) return "none stated";
  return "at most " + OptionValues::shown(factor) + " times the distance";
}

void print(const PluginListing& listing) {
  for (const PluginInfo& plugin : listing.usable)
    std::cout << std::left << std::setw(34) << plugin.full_name() << std::setw(18) << plugin.licence << plugin.summary
              << "\n";
  for (const PluginRefusal& refusal : listing.refused)
    std::cout << "refused " << refusal.file.string() << ": " << refusal.reason << "\n";
}

void print(const PluginInfo& plugin) {
  std::cout << plugin.full_name() << ": " << plugin.summary << "\n  licence    " << plugin.licence << "\n  file       "
            << plugin.file.string() << "\n";
  if (plugin.stage == ShortestPathSolver::stage)
    std::cout << "  guarantee  " << guarantee(plugin.default_factor) << "\n  needs      "
              << joined_or_nothing(words_of(plugin.needs)) << "\n  provides   "
              << joined_or_nothing(words_of(plugin.provides)) << "\n";
  for (const OptionInfo& option : plugin.options) {
    std::cout << "  option     " << option.name << "=" << option.default_value
              << (option.unit.empty() ? "" : " " + option.unit) << "  (";
    if (option.type == OptionType::integer || option.type == OptionType::number)
      std::cout << OptionValues::shown(option.minimum) << " to " << OptionValues::shown(option.maximum);
    else
      std::cout << option.choices;
    std::cout << ")  " << option.help << "\n";
  }
}

int list_plugins(const PluginArguments& arguments) {
  const PluginListing listing = PluginHost(arguments.plugin_path).list();
  if (arguments.json)
    std::cout << json_text(listing) << "\n";
  else
    print(listing);
  return 0;
}

/// All plugins of a name, whatever the stage; a path names a file.
int show_plugins(const PluginArguments& arguments) {
  const std::vector<PluginInfo> found = PluginHost(arguments.plugin_path).named(arguments.name);
  if (arguments.json)
    std::cout << json_text(found) << "\n";
  else
    std::for_each(found.begin(), found.end(), [](const PluginInfo& plugin) { print(plugin); });
  return 0;
}

void add_listing(const Command<PluginArguments>& command) {
  add_plugin_path(command.app, command.arguments.plugin_path);
  command.app.add_flag("--json", command.arguments.json, "As JSON on standard output");
}

}  // namespace

void add_plugins(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("plugins", "The plugins that are there");
  command.require_subcommand(1);
  add_listing(add_command(command, action, "list", "All plugins, and the files that were refused, with the reason",
                          list_plugins));
  const auto show = add_command(command, action, "show", "One plugin: guarantee, needs, options", show_plugins);
  show.app.add_option("NAME", show.arguments.name, "'cgal', 'solver_cgal', or the path of a file")->required();
  add_listing(show);
  add_plugins_check(command, action);
  add_plugins_new(command, action);
}

}  // namespace geodrome::cli
