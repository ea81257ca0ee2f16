// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

using PathArguments = JobArguments<PathJob>;

int write_path(const PathArguments& arguments) {
  const PathResult path = at_console(run_path, arguments);
  std::cout.precision(17);
  if (std::isinf(path.distance))
    std::cout << "unreachable (inf): no path\n";
  else
    std::cout << "distance " << path.distance << ", path of " << path.points.size() << " points, length " << path.length
              << "\n";
  if (path.flat && !path.flat->points.empty())
    std::cout << "on the triangles: path of " << path.flat->points.size() << " points, length " << path.flat->length
              << "\n";
  const auto tell_off = [](const char* end, double distance) {
    if (distance > 0)
      std::cout << end << " lies " << distance << " off the surface: its closest surface point is taken\n";
  };
  std::cout.precision(4);
  tell_off("the start", path.from_off_surface), tell_off("the end", path.to_off_surface);
  return tell_broken_promises(path.broken_promises, arguments.job.settings.stages.solver);
}

}  // namespace

void add_path(CLI::App& app, Action& action) {
  const auto [command, arguments] =
      add_command(app, action, "path", "A shortest path between two points, as a polyline on the surface", write_path);
  PathJob& job = arguments.job;
  add_input(command, job.input);
  const char* entry =
      "A row 'i', a point 'x,y,z', a place 'face,b0,b1,b2', or '@FILE' with one line as for 'distances --sources'";
  command.add_option("--from", job.from, entry)->required()->type_name("I");
  command.add_option("--to", job.to, entry)->required()->type_name("J");
  command.add_option("-o,--output", job.out, "The polyline: " + help_for_writing(Content::path))
      ->required()
      ->type_name("FILE");
  command
      .add_option("--flat", job.flat,
                  "With --metric smooth: the path on the triangles too, which the curve was made from")
      ->type_name("FILE");
  add_choice<ProjectionRule>(command, "--query", job.query,
                             {{"project", ProjectionRule::project}, {"insert", ProjectionRule::insert}},
                             "project: between closest surface points; insert: FROM becomes a vertex of the surface");
  add_metric(command, job.settings);
  add_solver(command, job.settings.stages);
  add_job_options(command, job.settings, arguments.quiet);
}

}  // namespace geodrome::cli
