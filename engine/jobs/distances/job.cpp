// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/formats/remedies.hpp"
#include "engine/formats/source_file.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/jobs/distances/report.hpp"
#include "engine/jobs/session_state.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/report/json.hpp"
#include "engine/search/lower_bounds.hpp"
#include "engine/search/many_searches.hpp"
#include "engine/search/named_points.hpp"
#include "engine/search/projection_rule.hpp"
#include "geodrome/engine/version.hpp"

namespace geodrome {

namespace {

/// What tells two lists of points apart: their places and start distances.
std::string digest(std::span<const NamedPoint> queries) {
  std::string bytes;
  const auto append = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const NamedPoint& query : queries) {
    append(query.place.state);
    append(query.place.at.face);
    for (const double b : query.place.at.b) append(b);
    append(query.place.position.x), append(query.place.position.y), append(query.place.position.z);
    append(query.place.vertex), append(query.start), append(query.row);
  }
  return std::to_string(queries.size()) + " points, " + input::content_hash(bytes);
}

Json chosen(const StageRecord& record) {
  Json json{{"plugin", record.plugin.full_name()}};
  for (const auto& [name, value] : record.options.all()) json[name] = value;
  return json;
}

/// Two runs that share this text make the same matrix, byte for byte.
std::string fingerprint(const DistanceJob& job, const Opened& opened, const PreparedSolver& solver,
                        std::span<const NamedPoint> sources, std::span<const NamedPoint> targets) {
  Json json{{"geodrome", version()}, {"input", opened.input.hash}};
  const ReadOptions& read = job.settings.read;
  json["as"] = opened.input.kind == InputKind::mesh ? "mesh" : "points";
  if (read.weld_tolerance > 0) json["weld_tolerance"] = read.weld_tolerance;
  json["weld"] = read.weld, json["drop_nonfinite"] = read.drop_nonfinite;
  if (!read.columns.empty()) json["columns"] = read.columns;
  json["weights"] = opened.input.weights.empty() ? "none" : opened.input.weights_hash;
  for (const StageRecord& stage : opened.surface.stages) json[stage.plugin.stage] = chosen(stage);
  json["solver"] = chosen(solver.record);
  json["query"] = name(job.query), json["max_distance"] = to_json(job.max_distance);
  json["sources"] = digest(sources), json["targets"] = digest(targets);
  if (plan_rows(solver, job.query, sources, job.max_distance)) json["searches"] = ManySearches::id;
  json["dtype"] = job.scalar == ScalarType::float64 ? "float64" : "float32";
  json["seed"] = job.settings.seed;
  if (opened.surface.part) json["part"] = "largest";
  if (opened.surface.smooth) json["metric"] = "smooth", json["smooth"] = chosen(opened.surface.smooth->record);
  return json.dump();
}

void check_bounds(const DistanceJob& job) {
  if (!job.bounds.empty() && job.matrix.empty())
    throw OptionError("there is no matrix whose lower bounds were to be written", remedies::matrix_output());
  if (job.nearest_bounds && job.nearest.empty())
    throw OptionError("there is no table of nearest sources to write lower bounds into", remedies::nearest_output());
  if (!job.bounds.empty()) check_bounds_rule(job.query);
  if (!job.bounds.empty() || job.nearest_bounds) check_bounds_metric(job.settings.metric);
}

/// Mistakes that would otherwise show after hours.
void check_arguments(const DistanceJob& job) {
  if (job.matrix.empty() && job.nearest.empty()) throw OptionError("nothing to write", remedies::distances_output());
  if (!job.nearest.empty() && job.query != ProjectionRule::project)
    throw OptionError("the nearest source is sought on one surface for all sources, the rule " +
                          std::string(name(job.query)) + " has one for each of them",
                      remedies::default_rule());
  check_bounds(job);
  check_limit(job.max_distance);
  if (!(job.audit_share >= 0 && job.audit_share <= 1)) throw OptionError("the audit's share must be from 0 to 1");
  if (job.resume && job.matrix.empty()) throw OptionError("there is no matrix to resume", remedies::matrix_output());
  check_ending(job.matrix, Content::matrix);
  check_ending(job.bounds, Content::matrix);
  check_ending(job.nearest, Content::nearest);
  check_ending(job.report, Content::report);
  check_mesh_ending(job.surface, job.settings.read);
  const std::filesystem::path outputs[] = {job.matrix, job.bounds, job.nearest, job.report, job.surface};
  const std::string selections[] = {job.sources, job.targets};
  check_outputs(outputs, files_read(job.input, job.settings.read, selections));
}

/// What the solver must provide whatever the surface.
Provides demands_of(const DistanceJob& job, const Selection& sources) {
  Provides demands = Provides::nothing;
  if (std::isfinite(job.max_distance)) demands |= Provides::radius_limit;
  if (!job.nearest.empty() && sources.has_starts()) demands |= Provides::start_distances;
  return demands;
}

/// Everything that is searched.
void search(RunRecord& record, const SourceSurfaces& surfaces, std::span<const NamedPoint> sources,
            Observer& observer) {
  const DistanceJob& job = record.job;
  const PreparedSolver& solver = record.solver;
  const TargetList& targets = surfaces.targets();
  const std::uint64_t seed = job.settings.seed;
  if (!job.nearest.empty()) {
    StageContext context("nearest", observer, 1, seed);
    record.nearest = find_nearest(solver, *surfaces.reconstruction(), sources, targets, job.max_distance,
                                  job.nearest_bounds, context);
    StageContext audit("audit", observer, 1, seed);
    const GivenDistances given{sources, targets, record.nearest->searched(), record.nearest->radius,
                               record.nearest->vertices};
    record.nearest->audit = audit_distances(solver, *surfaces.reconstruction(), given, job.audit_share, seed, audit);
  }
  if (!job.matrix.empty())
    record.matrix = compute_matrix(job, solver, surfaces, sources,
                                   fingerprint(job, record.start.opened, solver, sources, targets.named()), observer);
}

}  // namespace

JobReport run_distances(const DistanceJob& job, Observer& observer) {
  const Stopwatch total;
  check_arguments(job);
  const Selection from = parse_selection(job.sources), to = parse_selection(job.targets);
  if (to.has_starts())
    throw OptionError("a target has a start distance, which only sources have", "leave out what follows ' +' there");
  SessionState session(job.settings, observer, demands_of(job, from));
  if (!job.bounds.empty() || job.nearest_bounds) demand_lower_bounds(session.plugin);
  session.begin(job.input);
  const JobStart& start = session.start;
  const Opened& opened = start.opened;
  if (opened.refusal && !job.report.empty()) write_atomically(job.report, refusal_report(job, start) + "\n");
  throw_if_refused(start, observer);
  const std::vector<NamedPoint> sources = resolve(from, opened.input, opened.surface);
  demand_on_part(from, sources, opened.surface);
  check_rule(job.query, opened, sources);
  std::vector<NamedPoint> named = resolve(to, opened.input, opened.surface);
  const OffSurface off = tell_off_surface(opened.input, opened.surface, {{from, sources}, {to, named}}, observer);
  const SourceSurfaces surfaces(job.query, opened, std::move(named));
  const TargetList& targets = surfaces.targets();
  check_provides(session.plugin.info, job.query, sources, targets.named(), job.max_distance);

  RunRecord record{job, start, session.prepared(), sources.size(), targets.size(), off};
  search(record, surfaces, sources, observer);
  record.total_seconds = total.seconds();

  if (record.nearest) write_atomically(job.nearest, as_csv(*record.nearest, sources, targets.named()));
  if (!job.surface.empty()) record.surface_findings = write_mesh(job.surface, *opened.surface.mesh);
  tell(record.surface_findings, observer);
  JobReport report = write_report(record);
  if (!job.report.empty()) write_atomically(job.report, report.json + "\n");
  return report;
}

}  // namespace geodrome
