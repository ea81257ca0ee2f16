// SPDX-License-Identifier: MIT
#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

constexpr const char* about_pairs =
    "A pair a line, two entries separated by a comma; an entry is a row 'i', a point 'x y z' or 'face b0 b1 b2':\n"
    "  3, 17\n"
    "  12 0.2 0.3 0.5, 40 0.1 0.1 0.8   # blank lines and comments are passed over\n"
    "Only solvers that provide pair_queries can do this ('geodrome plugins show NAME' tells); with --metric smooth "
    "those\n"
    "that provide paths: each first entry of a pair is then searched from once.";

using PairArguments = JobArguments<PairJob>;

int answer_pairs(const PairArguments& arguments) {
  return tell(at_console(run_pairs, arguments), arguments.job.settings.stages.solver);
}

}  // namespace

void add_queries(CLI::App& app, Action& action) {
  const auto [command, arguments] =
      add_command(app, action, "queries", "Distances of many pairs of points, by a solver's pair oracle", answer_pairs);
  PairJob& job = arguments.job;
  command.footer(about_pairs);
  add_input(command, job.input);
  command.add_option("--pairs", job.pairs, "The pairs, one a line: see below")->required()->type_name("FILE");
  command.add_option("-o,--output", job.out, "One distance a pair: " + help_for_writing(Content::pairs))
      ->required()
      ->type_name("FILE");
  command.add_option("--index", job.index, "The oracle: read if FILE is there, else built and saved to it")
      ->type_name("FILE");
  command.add_option("--report", job.report, "Everything about the run, as JSON")->type_name("FILE");
  add_metric(command, job.settings);
  add_solver(command, job.settings.stages, Asked::pairs);
  add_job_options(command, job.settings, arguments.quiet);
}

}  // namespace geodrome::cli
