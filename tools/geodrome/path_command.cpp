// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <memory>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

struct Arguments {
  PathJob job;
  bool quiet = false;
};

int run(const Arguments& arguments) {
  const PathResult path =
      with_console(arguments.quiet, [&](Console& console) { return run_path(arguments.job, console); });
  std::cout.precision(17);
  if (std::isinf(path.distance))
    std::cout << "unreachable (inf): no path\n";
  else
    std::cout << "distance " << path.distance << ", path of " << path.points.size() << " points, length " << path.length
              << "\n";
  return 0;
}

}  // namespace

void add_path(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  PathJob& job = arguments->job;
  CLI::App& command = *app.add_subcommand("path", "A shortest path between two points, as a polyline on the surface");
  add_input(command, job.input);
  const char* entry = "An index, or '@FILE' with one line as for 'distances --sources'";
  command.add_option("--from", job.from, entry)->required()->type_name("I");
  command.add_option("--to", job.to, entry)->required()->type_name("J");
  command.add_option("-o,--output", job.out, "The polyline: .obj, .csv or .json")->required()->type_name("FILE");
  add_choice<ProjectionRule>(command, "--query", job.query, {{"project", ProjectionRule::project}, {"insert", ProjectionRule::insert}},
                        "project: between closest surface points; insert: FROM becomes a vertex of the surface");
  add_solver(command, job.settings.stages);
  add_sample_stages(command, job.settings.stages);
  add_read_options(command, job.settings.read);
  add_run_options(command, job.settings);
  add_quiet(command, arguments->quiet);
  command.callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace geodrome::cli
