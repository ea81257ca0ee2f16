// SPDX-License-Identifier: MIT
#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

using DistanceArguments = JobArguments<DistanceJob>;

int write_distances(const DistanceArguments& arguments) {
  return tell(at_console(run_distances, arguments), arguments.job.settings.stages.solver);
}

void add_distance_outputs(CLI::App& command, DistanceJob& job) {
  command.add_option("-o,--output", job.matrix, "The matrix, rows = sources: " + help_for_writing(Content::matrix))
      ->type_name("FILE");
  add_choice<ScalarType>(command, "--dtype", job.scalar,
                         {{"float64", ScalarType::float64}, {"float32", ScalarType::float32}}, "Numbers of an .npy");
  command.add_option("--nearest", job.nearest, "One search from all sources: " + help_for_writing(Content::nearest))
      ->type_name("FILE");
  command
      .add_option("--bounds", job.bounds,
                  "Lower bounds of the distances in OUTPUT, in its layout: no true one is below; for solvers with a "
                  "guarantee")
      ->type_name("FILE");
  command.add_flag("--nearest-bounds", job.nearest_bounds, "A column of lower bounds in the table of --nearest");
  command.add_option("--report", job.report, "Everything about the run, as JSON")->type_name("FILE");
  command.add_option("--surface", job.surface, "The surface that was used: " + help_for_writing(Content::mesh))
      ->type_name("FILE");
  command.add_flag("--resume", job.resume, "Go on with OUTPUT.partial of an interrupted run");
  command.add_flag("--yes", job.yes, "Consent to a matrix of more than 4 GB");
}

}  // namespace

void add_distances(CLI::App& app, Action& action) {
  const auto [command, arguments] =
      add_command(app, action, "distances", "Distances from sources to targets (default: all pairs)", write_distances);
  DistanceJob& job = arguments.job;
  add_input(command, job.input);
  add_distance_outputs(command, job);
  const char* list =
      "'all', rows '0,5,9', '1-5' or '0:100:10', points 'x y z', or '@FILE' with lines of these or 'face b0 b1 b2'";
  command.add_option("--sources", job.sources, std::string(list) + ", each with an optional '+ start'")
      ->type_name("LIST")
      ->capture_default_str();
  command.add_option("--targets", job.targets, list)->type_name("LIST")->capture_default_str();
  command.add_option("--max-distance", job.max_distance, "Farther is +inf (counted apart from unreachable)")
      ->check(number_from_to(0, infinity))
      ->type_name("R");
  add_choice<ProjectionRule>(
      command, "--query", job.query,
      {{"project", ProjectionRule::project}, {"insert", ProjectionRule::insert}, {"printed", ProjectionRule::printed}},
      "Points off the surface: project (closest surface point, D = max(surface distance, |st|)), "
      "insert (each source becomes a vertex of a surface of its own; D is not symmetric), printed (as "
      "insert, targets as the paper prints it: wrong near the source, for comparison only)");
  command.add_option("--audit", job.audit_share, "Share of the faces on which exactness is audited; 0: none")
      ->check(number_from_to(0, 1))
      ->type_name("SHARE")
      ->capture_default_str();
  add_metric(command, job.settings);
  add_solver(command, job.settings.stages);
  add_job_options(command, job.settings, arguments.quiet);
}

}  // namespace geodrome::cli
