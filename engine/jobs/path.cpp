// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/formats/remedies.hpp"
#include "engine/formats/table.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/search/projection_rule.hpp"
#include "engine/search/source_surface.hpp"
#include "engine/search/traced_path.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

namespace {

NamedPoint select_one(const std::string& text, const char* what, const Opened& opened) {
  const std::vector<NamedPoint> queries = select(text, opened.input, opened.surface);
  if (queries.size() != 1)
    throw OptionError(std::string(what) + " names " + std::to_string(queries.size()) + " points", "name one");
  if (queries[0].start != 0) throw OptionError(std::string(what) + " has no start distance of its own");
  if (queries[0].place.state == Place::State::dropped)
    throw OptionError(std::string(what) + ": row " + queries[0].label + " was dropped");
  return queries[0];
}

PathResult find_path(const PreparedSolver& solver, const SourceSurface& on, RunContext& context) {
  const NamedPoint &from = on.source, &to = on.targets->queries()[0];
  PathResult result;
  result.distance = std::numeric_limits<double>::infinity();
  const bool isolated = from.place.state == Place::State::isolated || to.place.state == Place::State::isolated;
  if (isolated) {
    if (from.place.vertex == to.place.vertex) result.distance = 0;
    return result;
  }
  const auto search = make_search(solver);
  const Source source{from.place.at, 0};
  const ShortestPathMap& map =
      run_search(solver, *search, {&source, 1}, {.targets = on.targets->points(), .keep = Keep::map}, context);
  const double on_surface = cross_boundary(solver.plugin.info, [&] { return on.targets->read(map, 0); });
  result.distance = std::max(on_surface, on.targets->lower_bound(from, 0));
  if (!std::isfinite(on_surface)) return result;
  PathResult path = trace_path(solver, map, to.place.at, *on.mesh);
  path.distance = result.distance;
  return path;
}

}  // namespace

PathResult run_path(const PathJob& job, Observer& observer) {
  if (job.query == ProjectionRule::printed)
    throw OptionError("the rule printed has no paths: its distances are minima over several points",
                      remedies::insertion_or_default_rule());
  check_ending(job.out, Content::path);
  const std::string selections[] = {job.from, job.to};
  check_outputs({&job.out, 1}, files_read(job.input, job.settings.read, selections));
  const PluginHost host(job.settings.plugin_path);
  const Opened opened = open_input(job.input, host, job.settings, observer);
  const NamedPoint from = select_one(job.from, "the start of the path", opened),
                   to = select_one(job.to, "the end of the path", opened);
  check_rule(job.query, opened, {&from, 1});
  const SourceSurface on = SourceSurfaces(job.query, opened, {to}).of(from);
  const PreparedSolver solver = prepare_solver(on.mesh, host, job.settings.stages.solver, job.settings, observer);
  check_provides(solver, {&on.source, 1}, on.targets->queries(), std::numeric_limits<double>::infinity());
  demand(solver, Provides::paths, "paths");
  StageContext context(ShortestPathSolver::stage, observer, 1, job.settings.seed);
  const PathResult result = find_path(solver, on, context);
  if (!job.out.empty()) write_atomically(job.out, format_to_write(job.out, Content::path).write_path(result));
  return result;
}

}  // namespace geodrome
