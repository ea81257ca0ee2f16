// SPDX-License-Identifier: MIT
#include <iomanip>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "engine/report/json.hpp"

namespace geodrome::cli {

namespace {

struct Arguments {
  CompareJob job;
  std::string stage;
  bool json = false, quiet = false;
};

/// "solver=A,B:k=v,C" names solvers; a comma followed by k=v belongs to the options of the one before.
std::vector<std::string> solvers_of(const std::string& stage) {
  constexpr std::string_view prefix = "solver=";
  if (!stage.starts_with(prefix))
    throw OptionError("--stage '" + stage + "': only solvers can be compared", "write --stage solver=A,B");
  std::vector<std::string> names;
  std::istringstream words(stage.substr(prefix.size()));
  for (std::string word; std::getline(words, word, ',');) {
    const bool is_option = word.find('=') != std::string::npos && word.find(':') == std::string::npos;
    if (is_option && !names.empty())
      names.back() += "," + word;
    else
      names.push_back(word);
  }
  return names;
}

Json to_json(const CompareRow& row) {
  if (!row.error.empty()) return {{"solver", row.solver}, {"error", row.error}};
  return {{"solver", row.solver},
          {"factor", geodrome::to_json(row.factor)},
          {"prepare_seconds", row.prepare_seconds},
          {"seconds_per_source", row.seconds_per_source},
          {"max_relative_difference", geodrome::to_json(row.max_difference)},
          {"mean_relative_difference", geodrome::to_json(row.mean_difference)},
          {"compared", row.compared},
          {"unreachable", row.unreachable},
          {"reach_differs", row.reach_differs}};
}

void print(const std::vector<CompareRow>& rows) {
  std::cout << std::left << std::setw(28) << "solver" << std::right << std::setw(12) << "prepare s" << std::setw(14)
            << "s per source" << std::setw(14) << "max rel diff" << std::setw(14) << "mean rel diff" << std::setw(13)
            << "unreachable"
            << "\n";
  for (const CompareRow& row : rows) {
    std::cout << std::left << std::setw(28) << row.solver << std::right;
    if (row.error.empty())
      std::cout << std::setprecision(4) << std::setw(12) << row.prepare_seconds << std::setw(14)
                << row.seconds_per_source << std::setw(14) << row.max_difference << std::setw(14) << row.mean_difference
                << std::setw(13) << row.unreachable << "\n";
    else
      std::cout << "  not run: " << row.error << "\n";
    if (row.reach_differs > 0)
      std::cout << "  " << row.reach_differs << " targets are reached by only one of it and the first\n";
  }
}

int run(Arguments arguments) {
  arguments.job.solvers = solvers_of(arguments.stage);
  const std::vector<CompareRow> rows =
      with_console(arguments.quiet, [&](Console& console) { return run_compare(arguments.job, console); });
  Json json = Json::array();
  int status = 0;
  for (const CompareRow& row : rows) {
    json.push_back(to_json(row));
    if (status == 0) status = row.error_status;
  }
  if (arguments.json)
    std::cout << text_of(json) << "\n";
  else
    print(rows);
  return status;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("compare", "Time and results of several solvers, on the same surface and sources");
  add_input(command, arguments->job.input);
  command.add_option("--stage", arguments->stage, "solver=A,B,...: all are compared with the first that can be run")
      ->required()
      ->type_name("LIST");
  command.add_option("--sources", arguments->job.sources, "As for 'distances'")
      ->type_name("LIST")
      ->capture_default_str();
  command.add_flag("--json", arguments->json, "As JSON on standard output");
  add_sample_stages(command, arguments->job.settings.stages);
  add_read_options(command, arguments->job.settings.read);
  add_run_options(command, arguments->job.settings);
  add_quiet(command, arguments->quiet);
  command.callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace geodrome::cli
