// SPDX-License-Identifier: MIT
#include <iostream>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"
#include "tools/geodrome/remedies.hpp"

namespace geodrome::cli {

namespace {

using CheckArguments = JobArguments<CheckJob>;

int check_file(const CheckArguments& arguments) {
  try {
    const CheckReport report = at_console(run_check, arguments);
    std::cout << (arguments.json ? report.json + "\n" : report.text);
    return report.refusal ? exit_status(*report.refusal) : 0;
  } catch (const InputError& error) {
    if (!arguments.json) throw;
    std::cout << unusable_json(arguments.job.input, error, words(error.coded_remedy())) << "\n";
    return exit_status(error);
  }
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command(
      app, action, "check",
      "What a file holds and what is wrong with it; of points, how good a sample they are. Status 3 if it cannot be "
      "used, 4 if the sample is refused",
      check_file);
  CheckJob& job = arguments.job;
  add_input(command, job.input);
  command.add_flag("--json", arguments.json, "As JSON on standard output");
  command.add_flag("--input-only", job.input_only, "Of points, no more than the file's own facts: no stage runs");
  add_job_options(command, job.settings, arguments.quiet);
}

}  // namespace geodrome::cli
