// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "geodrome/engine/jobs.hpp"

/// The subcommands of `geodrome`, each in a file of its own: options in, a call of the engine, output.
namespace geodrome::cli {

/// What the chosen subcommand does after parsing; its return value is the exit status.
using Action = std::function<int()>;

void add_distances(CLI::App& app, Action& action);
void add_surface(CLI::App& app, Action& action);
void add_path(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_plugins(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_shape(CLI::App& app, Action& action);

/// Options that several subcommands share, each declared once.
void add_input(CLI::App& command, std::filesystem::path& file);
void add_read_options(CLI::App& command, ReadOptions& read);
void add_sample_stages(CLI::App& command, StageChoice& stages);
void add_solver(CLI::App& command, StageChoice& stages);
void add_run_options(CLI::App& command, RunSettings& settings);
void add_plugin_path(CLI::App& command, std::vector<std::filesystem::path>& folders);
void add_quiet(CLI::App& command, bool& quiet);

}  // namespace geodrome::cli
