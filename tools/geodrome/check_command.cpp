// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"
#include "tools/geodrome/remedies.hpp"
#include "engine/report/json.hpp"

namespace geodrome::cli {

namespace {

struct Arguments {
  CheckJob job;
  bool json = false, quiet = false;
};

int run(const Arguments& arguments) {
  try {
    const CheckReport report =
        with_console(arguments.quiet, [&](Console& console) { return run_check(arguments.job, console); });
    std::cout << (arguments.json ? report.json + "\n" : report.text);
    return report.refusal ? exit_status(*report.refusal) : 0;
  } catch (const InputError& error) {
    if (!arguments.json) throw;
    const Json what{{"fault", name(error.fault())}, {"message", error.message()}, {"remedy", words(error.coded_remedy())}};
    std::cout << text_of(Json{{"usable", false}, {"file", arguments.job.input.string()}, {"error", what}}) << "\n";
    return exit_status(error);
  }
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CheckJob& job = arguments->job;
  CLI::App& command = *app.add_subcommand(
      "check",
      "What a file holds and what is wrong with it; of points, how good a sample they are. Status 3 if it cannot be "
      "used, 4 if the sample is refused");
  add_input(command, job.input);
  command.add_flag("--json", arguments->json, "As JSON on standard output");
  command.add_flag("--input-only", job.input_only, "Of points, no more than the file's own facts: no stage runs");
  add_sample_stages(command, job.settings.stages);
  add_read_options(command, job.settings.read);
  add_run_options(command, job.settings);
  add_quiet(command, arguments->quiet);
  command.callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace geodrome::cli
