// SPDX-License-Identifier: MIT
#include "engine/jobs/distances/report.hpp"

#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/formats/text.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/report/memory.hpp"
#include "engine/report/off_surface_text.hpp"
#include "engine/report/provenance.hpp"
#include "engine/report/smooth_text.hpp"
#include "engine/search/projection_rule.hpp"

namespace geodrome {

namespace {

using geodrome::to_json;  // the overloads below would hide them

Json to_json(const InvariantCheck& check) {
  Json json{
      {"holds", check.holds()}, {"promised", check.expected}, {"tested", check.tested}, {"violated", check.violated}};
  if (check.tested > 0)
    json.update(Json{
        {"worst", to_json(check.worst)}, {"tolerance", check.tolerance}, {"row", check.row}, {"column", check.column}});
  return json;
}

Json to_json(const IntervalFigures& certified) {
  return {{"vertices", certified.vertices},
          {"largest", to_json(certified.largest)},
          {"mean", to_json(certified.mean())},
          {"worst", to_json(certified.worst)}};
}

Json to_json(const PlanRecord& plan) {
  Json json{{"used", plan.used}, {"sources", plan.sources}, {"bytes", plan.bytes}, {"seconds", plan.seconds}};
  json["measures"] = Json::object();
  for (const auto& [name, value] : plan.measures) json["measures"][name] = to_json(value);
  return json;
}

Json to_json(const MatrixResult& matrix) {
  Json json{{"rows", matrix.rows},       {"columns", matrix.columns},
            {"bytes", matrix.bytes},     {"resumed_rows", matrix.resumed_rows},
            {"seconds", matrix.seconds}, {"first_row_seconds", matrix.first_row_seconds}};
  json["reach"] = {{"reached", matrix.reach.reached},         {"beyond_limit", matrix.reach.beyond_limit},
                   {"unreachable", matrix.reach.unreachable}, {"not_computed", matrix.reach.not_computed},
                   {"missed", matrix.reach.missed},           {"impossible", matrix.reach.impossible}};
  if (matrix.plan) json["many_searches"] = to_json(*matrix.plan);
  json["counters"] = Json::object();
  for (const auto& [name, value] : matrix.counters) json["counters"][name] = value;
  if (!matrix.insertions.empty()) json["insertions"] = matrix.insertions;
  if (matrix.certified) json["certified"] = to_json(*matrix.certified);
  if (matrix.smooth) json["smooth"] = to_json(*matrix.smooth);
  const Invariants& i = matrix.invariants;
  json["invariants"] = {{"sampled_rows", i.rows},
                        {"scale", to_json(i.scale)},
                        {"computed", to_json(i.computed)},
                        {"distance_to_itself", to_json(i.identity)},
                        {"not_below_euclid", to_json(i.euclid)},
                        {"symmetry", to_json(i.symmetry)},
                        {"triangle_inequality", to_json(i.triangle)}};
  return json;
}

Json because(const std::string& not_audited) { return {{"audited", false}, {"because", not_audited}}; }

/// The audit of the map of a repeated search.
Json to_json(const AuditResult& search, double scale) {
  return {{"faces", search.faces},
          {"pairs", search.pairs},
          {"paths", search.paths},
          {"scale", to_json(scale)},
          {"worst_lipschitz", to_json(search.worst_lipschitz)},
          {"worst_path", to_json(search.worst_path)},
          {"where", search.where}};
}

/// The audit of the nearest sources: of the search from all of them, and of what it gave against other searches.
Json to_json(const DistanceAudit& audit) {
  if (!audit.not_audited.empty()) return because(audit.not_audited);
  Json json{{"audited", true},
            {"from_sources", audit.from_sources},
            {"from_targets", audit.from_targets},
            {"targets", audit.targets},
            {"missed", audit.missed},
            {"impossible", audit.impossible},
            {"scale", to_json(audit.scale)},
            {"worst", to_json(audit.worst)},
            {"where", audit.where}};
  if (audit.search_not_audited.empty())
    json["search"] = to_json(audit.search, audit.scale);
  else
    json["search_not_audited"] = audit.search_not_audited;
  return json;
}

Json to_json(const NearestResult& nearest) {
  Json json{{"reached", nearest.reached}, {"beyond_limit", nearest.beyond_limit}, {"unreachable", nearest.unreachable},
            {"dropped", nearest.dropped}, {"seconds", nearest.seconds},           {"audit", to_json(nearest.audit)}};
  if (nearest.certified) json["certified"] = to_json(*nearest.certified);
  if (nearest.smooth) json["smooth"] = to_json(*nearest.smooth), json["compared_sources"] = nearest.compared;
  return json;
}

Json to_json(const RowsAudit& audit) {
  const DistanceAudit& found = audit.found;
  if (!found.not_audited.empty()) return because(found.not_audited);
  Json json = to_json(found.search, found.scale);
  json.update(Json{{"audited", true},
                   {"sources", audit.sources},
                   {"searches", audit.searches},
                   {"from_targets", found.from_targets},
                   {"worst_row", to_json(found.worst)},
                   {"where_row", found.where},
                   {"seconds", audit.seconds}});
  if (!found.search_not_audited.empty()) json["search_not_audited"] = found.search_not_audited;
  return json;
}

bool is_weighted(const RunRecord& record) { return !record.start.input().weights.empty(); }

std::string broken_interval(const IntervalFigures& certified, const std::string& whose) {
  return "the audit failed: the interval " + whose + " certifies at vertex " + std::to_string(certified.worst_vertex) +
         " of the surface misses by " + number_text(certified.worst) + " of the largest distance what must hold";
}

/// What the checks found that may not be, one line each.
std::vector<std::string> broken_promises_of(const RunRecord& record) {
  std::vector<std::string> broken;
  const auto demand = [&](bool holds, std::string what) {
    if (!holds) broken.push_back(std::move(what));
  };
  if (record.matrix) {
    const ReachCounts& reach = record.matrix->reach;
    demand(reach.missed == 0, std::to_string(reach.missed) + " distances within a component are inf");
    demand(reach.impossible == 0, std::to_string(reach.impossible) + " distances between components are numbers");
    const Invariants& i = record.matrix->invariants;
    const char* least = is_weighted(record) ? "the smallest weight times " : "";
    demand(i.computed.holds(), std::to_string(i.computed.violated) + " distances are nan");
    demand(i.identity.holds(), std::to_string(i.identity.violated) + " points are not at distance 0 from themselves");
    demand(i.euclid.holds(),
           std::to_string(i.euclid.violated) + " distances are shorter than " + least + "the straight line");
    demand(i.symmetry.holds(), std::to_string(i.symmetry.violated) + " pairs have two distances");
    demand(i.triangle.holds(), std::to_string(i.triangle.violated) + " triples break the triangle inequality");
    if (const auto& certified = record.matrix->certified; certified && !certified->hold())
      broken.push_back(broken_interval(*certified, "that row " + std::to_string(certified->worst_row)));
  }
  const auto demand_audit = [&](const DistanceAudit& audit) {
    for (std::string& what : broken_promises(audit)) broken.push_back(std::move(what));
  };
  if (record.matrix) demand_audit(record.matrix->audit.found);
  if (record.nearest) demand_audit(record.nearest->audit);
  if (record.nearest && record.nearest->certified && !record.nearest->certified->hold())
    broken.push_back(broken_interval(*record.nearest->certified, "that the search from all sources"));
  return broken;
}

Json settings_of(const DistanceJob& job) {
  Json json = settings_json(job.settings);
  json["query"] = name(job.query), json["max_distance"] = to_json(job.max_distance);
  if (!caveat(job.query).empty()) json["query_caveat"] = caveat(job.query);
  return json;
}

Json run_json(const RunRecord& record) {
  Json json = settings_of(record.job);
  json["sources"] = record.source_count, json["targets"] = record.target_count;
  if (record.matrix)
    json["output"] = record.job.matrix.string(),
    json["dtype"] = record.job.scalar == ScalarType::float64 ? "float64" : "float32";
  if (!record.job.bounds.empty()) json["bounds"] = record.job.bounds.string();
  return json;
}

/// The invariants that rule and solver promise, and those that they do not.
std::string promised_by(const RunRecord& record) {
  const Invariants& i = record.matrix->invariants;
  std::vector<std::string> promised, others;
  const auto add = [&](bool expected, const char* what) { (expected ? promised : others).push_back(what); };
  add(i.euclid.expected, is_weighted(record) ? "D >= smallest weight x Euclid" : "D >= Euclid");
  promised.push_back("D(s,s)");
  add(i.symmetry.expected, "symmetry");
  add(i.triangle.expected, "triangle inequality");
  promised.push_back("reach");
  if (others.empty()) return joined(promised);
  return joined(promised) + "; not promised by " +
         (record.job.query == ProjectionRule::project ? record.solver.plugin.info.full_name()
                                                      : "the rule " + std::string(name(record.job.query))) +
         ": " + joined(others);
}

void summarize_matrix(const RunRecord& record, std::ostream& out) {
  const DistanceJob& job = record.job;
  const MatrixResult& m = *record.matrix;
  out << "matrix     " << job.matrix.string() << ": " << m.rows << " x " << m.columns << " in " << m.seconds << " s; "
      << m.reach.unreachable << " unreachable, " << m.reach.beyond_limit << " beyond the limit, "
      << m.reach.not_computed << " not computed\n";
  if (m.plan && m.plan->used)
    out << "rows       prepared together: " << static_cast<double>(m.plan->bytes) / 1e6 << " MB in " << m.plan->seconds
        << " s\n";
  const bool whole = m.reach.missed == 0 && m.reach.impossible == 0;
  out << "invariants " << (m.invariants.holds() && whole ? "hold" : "VIOLATED") << " (" << promised_by(record) << ")\n";
}

void summarize_certified(const std::optional<IntervalFigures>& certified, const char* of, std::ostream& out) {
  if (!certified) return;
  out << "certified  " << of << "off by at most " << certified->largest << " of the distance, " << certified->mean()
      << " in the mean (" << certified->vertices << " vertices reached)\n";
}

void summarize_audit(const DistanceAudit& audit, bool nearest, std::ostream& out) {
  out << "audit      " << (nearest ? "nearest: " : "");
  if (!audit.not_audited.empty()) return void(out << "not audited: " << audit.not_audited << "\n");
  if (audit.search_not_audited.empty())
    out << audit.search.faces << " faces, " << audit.search.paths << " paths";
  else
    out << "its own search not audited (" << audit.search_not_audited << ")";
  if (nearest) out << "; " << audit.from_sources << " searches from sources, " << audit.from_targets << " from targets";
  out << ": worst violation " << audit.worst_of_all() << " of the largest distance\n";
}

void summarize(const RunRecord& record, const SurfaceFacts& surface, const SampleReport* sample, std::ostream& out) {
  out.precision(4);
  summarize_provenance(record.start.input(), surface, record.solver, out);
  summarize(record.off_surface, out);
  if (record.matrix) summarize_matrix(record, out);
  if (record.nearest)
    out << "nearest    " << record.job.nearest.string() << ": " << record.nearest->reached << " reached, "
        << record.nearest->beyond_limit << " beyond the limit, " << record.nearest->unreachable << " unreachable in "
        << record.nearest->seconds << " s\n";
  if (record.matrix) summarize_certified(record.matrix->certified, "", out);
  if (record.nearest) summarize_certified(record.nearest->certified, "nearest: ", out);
  const std::optional<FittedSurface>& fitted = record.start.surface().smooth;
  if (record.matrix && record.matrix->smooth) summarize_smooth(*record.matrix->smooth, *fitted, "", out);
  if (record.nearest && record.nearest->smooth) summarize_smooth(*record.nearest->smooth, *fitted, "nearest: ", out);
  if (record.matrix) summarize_audit(record.matrix->audit.found, false, out);
  if (record.nearest) summarize_audit(record.nearest->audit, true, out);
  if (sample) print_short(*sample, out);
}

}  // namespace

JobReport write_report(const RunRecord& record) {
  const Opened& opened = record.start.opened;
  const std::optional<SampleReport>& sample = record.start.sample;
  const SurfaceFacts facts = sample ? *sample->surface : facts_of(*opened.surface.mesh);
  Json json{{"geodrome", run_json(record)}};
  add_provenance(json, opened, sample, facts, record.solver);
  add_off_surface(json, record.off_surface);
  if (!record.surface_findings.empty())
    json["surface_file"] = {{"file", record.job.surface.string()}, {"findings", to_json(record.surface_findings)}};
  if (record.matrix) json["matrix"] = to_json(*record.matrix);
  if (record.nearest) json["nearest"] = to_json(*record.nearest);
  json["audit"] = record.matrix ? to_json(record.matrix->audit) : to_json(record.nearest->audit);
  const std::vector<std::string> broken = broken_promises_of(record);
  json["broken_promises"] = broken;
  json["timings"] = {{"read", opened.read_seconds},
                     {"surface", opened.surface_seconds},
                     {"prepare", record.solver.record.seconds},
                     {"total", record.total_seconds}};
  json["peak_memory_bytes"] = memory_peak();
  TextOutput summary;
  summarize(record, facts, sample ? &*sample : nullptr, summary);
  return {text_of(json), summary.str(), broken};
}

std::string refusal_report(const DistanceJob& job, const JobStart& start) {
  return refusal_report(settings_of(job), start.opened, *start.sample);
}

}  // namespace geodrome
