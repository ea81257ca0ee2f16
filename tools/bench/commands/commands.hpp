// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "geodrome/engine/pipeline.hpp"

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
void add_memory(CLI::App& app, Action& action);
void add_exactness(CLI::App& app, Action& action);
void add_fuzz(CLI::App& app, Action& action);
void add_factor(CLI::App& app, Action& action);
void add_section4(CLI::App& app, Action& action);
void add_queries(CLI::App& app, Action& action);

/// Options that several subcommands share, each declared once.
void add_stages(CLI::App& command, RunSettings& settings);   ///< plugins of stages 1 to 4, --plugin-path
void add_threads(CLI::App& command, RunSettings& settings);  ///< default 1

}  // namespace geodrome::bench
