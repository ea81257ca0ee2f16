// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"
#include "tools/bench/samples/manifold_task.hpp"

/// The subcommands of `geodrome-bench`, each in a file of its own.
namespace geodrome::bench {

/// What the chosen subcommand does after parsing.
using Action = std::function<void()>;

void add_solvers(CLI::App& app, Action& action);
void add_samples(CLI::App& app, Action& action);
void add_accuracy(CLI::App& app, Action& action);
void add_cost(CLI::App& app, Action& action);
void add_growth(CLI::App& app, Action& action);
void add_repeat(CLI::App& app, Action& action);
void add_matrix(CLI::App& app, Action& action);
void add_memory(CLI::App& app, Action& action);
void add_exactness(CLI::App& app, Action& action);
void add_fuzz(CLI::App& app, Action& action);
void add_factor(CLI::App& app, Action& action);
void add_section4(CLI::App& app, Action& action);
void add_queries(CLI::App& app, Action& action);
void add_audit(CLI::App& app, Action& action);

/// A subcommand, and what its options write into.
template <class Arguments>
struct Command {
  CLI::App& app;
  Arguments& arguments;
};

/// Adds a subcommand that does `run`; its help ends with `meaning`. Its arguments live as long as the app or the
/// action.
template <class Arguments>
Command<Arguments> add_command(CLI::App& parent, Action& action, const std::string& name, const std::string& about,
                               const char* meaning, void (*run)(const Arguments&)) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = *parent.add_subcommand(name, about);
  app.footer(meaning);
  app.callback([&action, arguments, run] { action = [arguments, run] { run(*arguments); }; });
  return {app, *arguments};
}

/// A solver that is judged or timed, the peer that it is held against, and where plugins are looked for first.
struct Rivals {
  std::string solver = "chen_han", peer = "cgal";
  std::vector<std::filesystem::path> plugin_path;
};

inline constexpr const char* one_solver = "NAME[:key=value,...]";

/// Options that several subcommands share, each declared once.
void add_mesh(CLI::App& command, std::string& mesh);
void add_meshes(CLI::App& command, std::vector<std::string>& meshes);
void add_solver(CLI::App& command, Rivals& rivals, const char* help = one_solver);  ///< with --plugin-path
void add_peer(CLI::App& command, Rivals& rivals, const char* help = one_solver);
void add_stages(CLI::App& command, RunSettings& settings);   ///< plugins of stages 1 to 4, --plugin-path
void add_threads(CLI::App& command, RunSettings& settings);  ///< default 1

/// What true distances on a shape start from, and how many there are.
void add_truth(CLI::App& command, TruthChoice& choice);

/// A number that must be positive.
CLI::Option* add_count(CLI::App& command, const char* flag, std::size_t& count, const char* help);

/// Values separated by commas.
template <class Value>
CLI::Option* add_list(CLI::App& command, const char* flag, std::vector<Value>& values, const char* help) {
  return command.add_option(flag, values, help)->delimiter(',')->allow_extra_args(false)->capture_default_str();
}

/// How searches of a judged solver are chosen and given up.
template <class Options>
void add_judging(CLI::App& command, Options& options) {
  command.add_option("--points", options.points, "in faces, compared beside the vertices")->capture_default_str();
  command.add_option("--seed", options.seed, "chooses sources and points")->capture_default_str();
  command.add_option("--seconds", options.seconds, "a search that takes longer is given up")->capture_default_str();
}

}  // namespace geodrome::bench
