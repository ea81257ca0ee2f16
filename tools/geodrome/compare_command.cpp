// SPDX-License-Identifier: MIT
#include <iostream>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

using CompareArguments = JobArguments<CompareJob>;

/// Finer meshes grow by 4 each: more than this would hold more faces than an index can count.
constexpr std::uint64_t most_levels = 16;
constexpr std::uint64_t most_paths = 1000;

int compare_plugins(const CompareArguments& arguments) {
  const CompareReport report = at_console(run_compare, arguments);
  std::cout << (arguments.json ? report.json + "\n" : report.table);
  const int broken = tell_broken_promises(report.broken_promises, "those named");
  return broken != 0 ? broken : report.error_status;
}

void add_judgement(CLI::App& command, CompareJob& job) {
  command
      .add_option("--truth", job.truth,
                  "What is right: 'first' (the first combination that runs), 'exact' or 'exact:SOLVER' (an exact "
                  "solver on each combination's own surface), or FILE.npy: a row per source, or all pairs")
      ->type_name("TRUTH")
      ->capture_default_str();
  command
      .add_option("--growth", job.growth,
                  "Also on so many other sizes: a mesh with its faces cut in 4 again and again, or 1/2, 1/4, ... of "
                  "the points")
      ->check(whole_number_up_to(most_levels))
      ->type_name("LEVELS")
      ->capture_default_str();
}

void add_comparison_outputs(CLI::App& command, CompareArguments& arguments) {
  CompareJob& job = arguments.job;
  command.add_flag("--json", arguments.json, "Figures as JSON on standard output, in place of the table");
  command.add_option("-o,--output", job.figures, "The same JSON in a file")->type_name("FIGURES.json");
  command.add_option("--html", job.page, "A page with table, plots, and the surface in 3D: one file, no network")
      ->type_name("PAGE.html");
  command.add_option("--paths", job.paths, "Paths per source on the page: to the farthest target, and others")
      ->check(whole_number_up_to(most_paths))
      ->type_name("K")
      ->capture_default_str();
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  const auto [command, arguments] =
      add_command(app, action, "compare",
                  "Time, memory and errors of combinations of plugins, on the same input and sources, on one thread",
                  compare_plugins);
  CompareJob& job = arguments.job;
  add_input(command, job.input);
  command
      .add_option("--stage", job.varied,
                  "STAGE=A,B[:k=v,...]: choices for a stage; with several --stage all their combinations")
      ->allow_extra_args(false)
      ->type_name("STAGE=LIST");
  command.add_option("--sources", job.sources, "As for 'distances'; targets are all rows")
      ->type_name("LIST")
      ->capture_default_str();
  add_judgement(command, job);
  add_comparison_outputs(command, arguments);
  add_metric(command, job.settings);
  add_solver(command, job.settings.stages);
  add_sample_stages(command, job.settings.stages);
  add_read_options(command, job.settings.read);
  add_plugin_path(command, job.settings.plugin_path);
  add_seed(command, job.settings);
  add_quiet(command, arguments.quiet);
}

}  // namespace geodrome::cli
