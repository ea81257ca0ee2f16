// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <iostream>

#include "geodrome/engine/boundary.hpp"
#include "tools/bench/commands/commands.hpp"

int main(int argc, char** argv) {
  geodrome::install_crash_handlers();
  CLI::App app("Measures Geodrome's plugins.", "geodrome-bench");
  app.require_subcommand(1);
  geodrome::bench::Action action;
  using namespace geodrome::bench;
  for (const auto add : {add_solvers, add_samples, add_accuracy, add_cost, add_growth, add_repeat, add_matrix,
                         add_memory, add_exactness, add_fuzz, add_factor, add_section4, add_queries, add_audit})
    add(app, action);
  CLI11_PARSE(app, argc, argv);
  try {
    action();
  } catch (const std::exception& error) {
    std::cerr << "geodrome-bench: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
