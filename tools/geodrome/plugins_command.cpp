// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

#include "engine/report/json.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "tools/geodrome/commands.hpp"

namespace geodrome::cli {

namespace {

struct Arguments {
  std::vector<std::filesystem::path> plugin_path;
  std::string name;
  bool json = false;
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "nothing" : text;
}

std::string guarantee(double factor) {
  if (factor == 1) return "exact";
  if (std::isinf(factor)) return "none stated";
  return "at most " + to_json(factor).dump() + " times the distance";
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
              << joined(words_of(plugin.needs)) << "\n  provides   " << joined(words_of(plugin.provides)) << "\n";
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

int list(const Arguments& arguments) {
  const PluginHost host(arguments.plugin_path);
  const PluginListing listing = host.list();
  if (arguments.json)
    std::cout << text_of(to_json(listing)) << "\n";
  else
    print(listing);
  return 0;
}

/// All plugins of a name, whatever the stage; a path names a file.
int show(const Arguments& arguments) {
  const std::vector<PluginInfo> found = PluginHost(arguments.plugin_path).named(arguments.name);
  Json json = Json::array();
  for (const PluginInfo& plugin : found) json.push_back(to_json(plugin));
  if (arguments.json)
    std::cout << text_of(json) << "\n";
  else
    std::for_each(found.begin(), found.end(), [](const PluginInfo& plugin) { print(plugin); });
  return 0;
}

}  // namespace

void add_plugins(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("plugins", "The plugins that are there");
  command.require_subcommand(1);
  CLI::App& list_command =
      *command.add_subcommand("list", "All plugins, and the files that were refused, with the reason");
  CLI::App& show_command = *command.add_subcommand("show", "One plugin: guarantee, needs, options");
  show_command.add_option("NAME", arguments->name, "'cgal', 'solver_cgal', or the path of a file")->required();
  for (CLI::App* sub : {&list_command, &show_command}) {
    add_plugin_path(*sub, arguments->plugin_path);
    sub->add_flag("--json", arguments->json, "As JSON on standard output");
  }
  list_command.callback([&action, arguments] { action = [arguments] { return list(*arguments); }; });
  show_command.callback([&action, arguments] { action = [arguments] { return show(*arguments); }; });
  add_plugins_check(command, action);
  add_plugins_new(command, action);
}

}  // namespace geodrome::cli
