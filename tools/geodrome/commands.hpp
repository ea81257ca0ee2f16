// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "geodrome/engine/accuracy.hpp"
#include "geodrome/engine/formats.hpp"
#include "geodrome/engine/jobs.hpp"

/// The subcommands of `geodrome`, each in a file of its own: options in, a call of the engine, output.
namespace geodrome::cli {

/// What the chosen subcommand does after parsing; its return value is the exit status.
using Action = std::function<int()>;

void add_distances(CLI::App& app, Action& action);
void add_queries(CLI::App& app, Action& action);
void add_surface(CLI::App& app, Action& action);
void add_path(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_plugins(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_shape(CLI::App& app, Action& action);

/// Subcommands of 'plugins'.
void add_plugins_check(CLI::App& plugins, Action& action);
void add_plugins_new(CLI::App& plugins, Action& action);

/// A subcommand, and what its options write into.
template <class Arguments>
struct Command {
  CLI::App& app;
  Arguments& arguments;
};

/// Adds a subcommand that does `run`. Its arguments live as long as `parent` or the action does.
template <class Arguments>
Command<Arguments> add_command(CLI::App& parent, Action& action, const std::string& name, const std::string& about,
                               int (*run)(const Arguments&)) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = *parent.add_subcommand(name, about);
  app.callback([&action, arguments, run] { action = [arguments, run] { return run(*arguments); }; });
  return {app, *arguments};
}

/// Options that several subcommands share, each declared once.
void add_input(CLI::App& command, std::filesystem::path& file);
/// By name, or by accuracy for what is asked of it.
void add_solver(CLI::App& command, StageChoice& stages, Asked asked = Asked::searches);
/// On the triangles or on the smooth surface over them.
void add_metric(CLI::App& command, RunSettings& settings);
/// What every job has: sample stages, reading, plugins, threads, seed, quiet.
void add_job_options(CLI::App& command, RunSettings& settings, bool& quiet);
void add_sample_stages(CLI::App& command, StageChoice& stages);
void add_read_options(CLI::App& command, ReadOptions& read);
void add_threads(CLI::App& command, unsigned& threads, const std::string& help);
void add_seed(CLI::App& command, RunSettings& settings);
void add_plugin_path(CLI::App& command, std::vector<std::filesystem::path>& folders);
void add_quiet(CLI::App& command, bool& quiet);

/// Gives options whose value may be left out the one that is meant: --weld stands before a number or is --weld 0. CLI11
/// would take the next word for the value, whatever it is.
void fill_in_values(std::vector<std::string>& words);

/// Checks of option values. CLI11's own take NaN for a number in any range and a negative whole number for a huge one.
CLI::Validator number_from_to(double low, double high);
CLI::Validator whole_number_up_to(std::uint64_t high);
/// One of the words, of which the value at the same place is taken.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& flag, Value& value,
                        const std::map<std::string, Value>& values, const std::string& help) {
  std::vector<std::string> words;
  std::string standard;
  for (const auto& [word, meaning] : values) {
    words.push_back(word);
    if (meaning == value) standard = word;
  }
  const auto set = [&value, values](const std::string& word) { value = values.at(word); };
  return command.add_option_function<std::string>(flag, set, help)
      ->check(CLI::IsMember(words))
      ->type_name("WORD")
      ->default_str(standard);
}

}  // namespace geodrome::cli
