// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/report/json.hpp"
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

std::string as_obj(const PathResult& path) {
  std::string text, line = "l";
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    const Vec3& p = path.positions[i];
    text += "v " + number_text(p.x) + " " + number_text(p.y) + " " + number_text(p.z) + "\n";
    line += " " + std::to_string(i + 1);
  }
  return path.positions.empty() ? "# no path\n" : text + line + "\n";
}

std::string as_csv(const PathResult& path) {
  std::string text = "x,y,z,face,b0,b1,b2\n";
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    const Vec3& p = path.positions[i];
    const SurfacePoint& at = path.points[i];
    text += number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z) + "," + std::to_string(at.face);
    for (const double b : at.b) text += "," + number_text(b);
    text += "\n";
  }
  return text;
}

std::string as_json(const PathResult& path) {
  Json json{{"distance", to_json(path.distance)}, {"length", to_json(path.length)}, {"points", Json::array()}};
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    const Vec3& p = path.positions[i];
    json["points"].push_back(
        {{"position", {p.x, p.y, p.z}}, {"face", path.points[i].face}, {"barycentric", path.points[i].b}});
  }
  return json.dump(1) + "\n";
}

using Format = std::string (*)(const PathResult&);

/// Known before anything is computed, so that a wrong ending costs no waiting.
Format format_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".obj") return as_obj;
  if (ending == ".csv") return as_csv;
  if (ending == ".json") return as_json;
  throw OptionError(file.string() + ": a path is written as .obj, .csv or .json");
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
  const Format format = job.out.empty() ? nullptr : format_of(job.out);
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
  if (format) write_atomically(job.out, format(result));
  return result;
}

}  // namespace geodrome
