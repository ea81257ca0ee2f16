// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

constexpr const char* about_pairs =
    "A pair a line, two entries separated by a comma; an entry is a row 'i', a point 'x y z' or 'face b0 b1 b2':\n"
    "  3, 17\n"
    "  12 0.2 0.3 0.5, 40 0.1 0.1 0.8   # blank lines and comments are passed over\n"
    "Only solvers that provide pair_queries can do this ('geodrome plugins show NAME' tells).";

struct Arguments {
  PairJob job;
  bool quiet = false;
};

int run(const Arguments& arguments) {
  const JobReport report =
      with_console(arguments.quiet, [&](Console& console) { return run_pairs(arguments.job, console); });
  std::cout << report.summary;
  return tell_broken_promises(report.broken_promises, arguments.job.settings.stages.solver);
}

}  // namespace

void add_queries(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  PairJob& job = arguments->job;
  CLI::App& command = *app.add_subcommand("queries", "Distances of many pairs of points, by a solver's pair oracle");
  command.footer(about_pairs);
  add_input(command, job.input);
  command.add_option("--pairs", job.pairs, "The pairs, one a line: see below")->required()->type_name("FILE");
  command
      .add_option("-o,--output", job.out,
                  "One distance a pair: .npy (float64) or .csv (pair, from, to, distance, reach)")
      ->required()
      ->type_name("FILE");
  command.add_option("--index", job.index, "The oracle: read if FILE is there, else built and saved to it")
      ->type_name("FILE");
  command.add_option("--report", job.report, "Everything about the run, as JSON")->type_name("FILE");
  add_solver(command, job.settings.stages);
  add_sample_stages(command, job.settings.stages);
  add_read_options(command, job.settings.read);
  add_run_options(command, job.settings);
  add_quiet(command, arguments->quiet);
  command.callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace geodrome::cli
