// SPDX-License-Identifier: MIT
#include "engine/jobs/pairs/report.hpp"

#include "engine/formats/text_stream.hpp"
#include "engine/report/memory.hpp"
#include "engine/report/off_surface_text.hpp"
#include "engine/report/provenance.hpp"
#include "engine/report/smooth_text.hpp"

namespace geodrome {

namespace {

/// What the checks found that may not be, one line each.
std::vector<std::string> broken_promises(const PairDistances& distances) {
  std::vector<std::string> broken;
  const auto demand_none = [&](std::uint64_t count, const char* what) {
    if (count > 0) broken.push_back(std::to_string(count) + " distances " + what);
  };
  demand_none(distances.reach.missed, "within a component are inf");
  demand_none(distances.reach.impossible, "between components are numbers");
  demand_none(distances.below_euclid, "are shorter than the straight line");
  demand_none(distances.not_zero, "of points from themselves are not 0");
  if (!distances.audit.holds())
    broken.push_back("the audit failed: pair " + std::to_string(distances.audit.worst_pair) +
                     " and a search for it differ by more than the factor allows");
  return broken;
}

Json oracle_json(const PairRecord& record) {
  const ReadyOracle& oracle = *record.oracle;
  Json json{{"origin", oracle.was_read ? "read" : "built"}, {"seconds", oracle.seconds}};
  if (!record.job.index.empty()) json["index"] = record.job.index.string();
  if (oracle.was_saved) json["save_seconds"] = oracle.save_seconds;
  if (oracle.was_read || oracle.was_saved) json["index_bytes"] = oracle.index_bytes;
  return json;
}

Json pairs_json(const PairRecord& record) {
  const PairDistances& d = record.distances;
  Json json{{"file", record.job.pairs.string()}, {"hash", record.list.hash}, {"count", d.values.size()}};
  record.oracle ? json["asked_of_the_oracle"] = d.asked : json["searches"] = d.searches;
  json.update(Json{{"reached", d.reach.reached},
                   {"unreachable", d.reach.unreachable},
                   {"not_computed", d.reach.not_computed},
                   {"missed", d.reach.missed},
                   {"impossible", d.reach.impossible},
                   {"below_euclid", d.below_euclid},
                   {"not_zero", d.not_zero},
                   {"seconds", d.seconds},
                   {"threads", d.threads}});
  if (record.oracle) json["microseconds_per_query"] = d.microseconds();
  if (d.smooth) json["smooth"] = to_json(*d.smooth);
  return json;
}

Json audit_json(const PairAudit& audit) {
  if (!audit.not_audited.empty()) return {{"audited", false}, {"because", audit.not_audited}};
  return {{"audited", true}, {"pairs", audit.pairs}, {"worst", to_json(audit.worst)}, {"worst_pair", audit.worst_pair}};
}

void summarize_oracle(const PairJob& job, const ReadyOracle& oracle, std::ostream& out) {
  out << "oracle     ";
  if (oracle.was_read)
    out << "read from " << job.index.string() << " in " << oracle.seconds << " s: " << oracle.index_bytes << " bytes\n";
  else if (oracle.was_saved)
    out << "built in " << oracle.seconds << " s, saved to " << job.index.string() << ": " << oracle.index_bytes
        << " bytes\n";
  else
    out << "built in " << oracle.seconds << " s, not saved\n";
}

void summarize_pairs(const PairJob& job, const PairDistances& d, std::ostream& out) {
  out << "pairs      " << job.out.string() << ": " << d.values.size() << " in " << d.seconds << " s, ";
  if (d.smooth)
    out << d.searches << (d.searches == 1 ? " search; " : " searches; ");
  else
    out << d.microseconds() << " us a query; ";
  out << d.reach.unreachable << " unreachable, " << d.reach.not_computed << " not computed\n";
  out << "invariants " << (d.sound() ? "hold" : "VIOLATED") << " (D >= Euclid, D(s,s), reach)\n";
  if (d.audit.not_audited.empty())
    out << "audit      " << d.audit.pairs << " pairs searched for anew: worst violation of the factor " << d.audit.worst
        << "\n";
  else
    out << "audit      not audited: " << d.audit.not_audited << "\n";
}

std::string summary_of(const PairRecord& record, const SurfaceFacts& surface, const SampleReport* sample) {
  TextOutput out;
  out.precision(4);
  summarize_provenance(record.start.input(), surface, record.solver, out);
  summarize(record.off_surface, out);
  if (record.oracle) summarize_oracle(record.job, *record.oracle, out);
  summarize_pairs(record.job, record.distances, out);
  if (record.distances.smooth) summarize_smooth(*record.distances.smooth, *record.start.surface().smooth, "", out);
  if (sample) print_short(*sample, out);
  return out.str();
}

}  // namespace

JobReport write_report(const PairRecord& record) {
  const Opened& opened = record.start.opened;
  const std::optional<SampleReport>& sample = record.start.sample;
  const SurfaceFacts facts = sample ? *sample->surface : facts_of(*opened.surface.mesh);
  Json json{{"geodrome", settings_json(record.job.settings)}};
  json["geodrome"]["output"] = record.job.out.string();
  add_provenance(json, opened, sample, facts, record.solver);
  add_off_surface(json, record.off_surface);
  if (record.oracle) json["oracle"] = oracle_json(record);
  json["pairs"] = pairs_json(record);
  json["audit"] = audit_json(record.distances.audit);
  const std::vector<std::string> broken = broken_promises(record.distances);
  json["broken_promises"] = broken;
  json["timings"] = {
      {"read", opened.read_seconds}, {"surface", opened.surface_seconds}, {"prepare", record.solver.record.seconds}};
  if (record.oracle) json["timings"]["oracle"] = record.oracle->seconds;
  json["timings"]["queries"] = record.distances.seconds;
  json["timings"]["total"] = record.total_seconds;
  json["peak_memory_bytes"] = memory_peak();
  return {text_of(json), summary_of(record, facts, sample ? &*sample : nullptr), broken};
}

std::string refusal_report(const PairJob& job, const JobStart& start) {
  return refusal_report(settings_json(job.settings), start.opened, *start.sample);
}

}  // namespace geodrome
