// SPDX-License-Identifier: MIT
#include "engine/report/provenance.hpp"

#include <cmath>
#include <ostream>

#include "engine/report/memory.hpp"
#include "engine/report/weights_text.hpp"
#include "geodrome/engine/version.hpp"

namespace geodrome {

namespace {

using geodrome::to_json;  // the overloads below would hide them

Json stages_json(const std::vector<StageRecord>& stages) {
  Json json = Json::array();
  for (const StageRecord& stage : stages) json.push_back(to_json(stage));
  return json;
}

/// What smooth distances claim, and what not.
constexpr const char* smooth_caveat =
    "the length of a curve on the fitted surface, to fourth order in the spacing of its nodes: no upper bound of the "
    "distance on it, and not below the straight line; the shortest path on the triangles is followed, so that near a "
    "cut locus the other one of two ways may be shorter; where no surface is trusted the way is flat";

Json to_json(const FittedSurface& fitted) {
  Json json = geodrome::to_json(fitted.record);
  json["trusted_faces"] = fitted.trusted_faces;
  json["mean_deviation"] = to_json(fitted.mean_deviation),
  json["largest_deviation"] = to_json(fitted.largest_deviation);
  return json;
}

void summarize_surface(const Input& input, const SurfaceFacts& surface, std::ostream& out) {
  out << "input      " << input.file.string() << ": " << input.facts.rows
      << (input.kind == InputKind::mesh ? " vertices" : " points") << "\n";
  if (!input.weights.empty()) out << "weights    " << weights_text(input) << "\n";
  out << "surface    " << surface.vertices << " vertices, " << surface.faces << " faces, "
      << (surface.closed ? "closed" : "bordered") << ", " << surface.components
      << (surface.components == 1 ? " component" : " components");
  if (surface.genus) out << ", genus " << *surface.genus;
  out << "\n";
}

void summarize_solver(const PreparedSolver& solver, std::ostream& out) {
  out << "solver     " << solver.plugin.info.full_name() << ", ";
  if (solver.plugin.factor == 1)
    out << "exact\n";
  else if (std::isinf(solver.plugin.factor))
    out << "no stated guarantee\n";
  else
    out << "at most " << solver.plugin.factor << " times the distance\n";
}

}  // namespace

Json settings_json(const RunSettings& settings) {
  Json json{{"version", version()},
            {"interface_version", interface_version},
            {"build", build_tag},
            {"seed", settings.seed},
            {"threads", thread_count(settings)}};
  if (settings.part == Part::largest) json["part"] = "largest";
  if (settings.metric == Metric::smooth) json["metric"] = "smooth", json["metric_caveat"] = smooth_caveat;
  return json;
}

void add_surface(Json& json, const Opened& opened, const std::optional<SampleReport>& sample,
                 const SurfaceFacts& surface) {
  json["surface"] = to_json(surface);
  if (sample) json.update(to_json(*sample));
  json["surface"]["findings"] = to_json(opened.surface.findings);
  json["stages"] = stages_json(opened.surface.stages);
  if (opened.surface.smooth) json["smooth_surface"] = to_json(*opened.surface.smooth);
}

void add_provenance(Json& json, const Opened& opened, const std::optional<SampleReport>& sample,
                    const SurfaceFacts& surface, const PreparedSolver& solver) {
  json["input"] = to_json(opened.input);
  add_surface(json, opened, sample, surface);
  json["stages"].push_back(to_json(solver.record));
  json["solver_factor"] = to_json(solver.plugin.factor);
}

std::string refusal_report(const Json& settings, const Opened& opened, const SampleReport& sample) {
  Json json{{"geodrome", settings}, {"input", to_json(opened.input)}};
  json.update(to_json(sample));
  json["stages"] = stages_json(opened.surface.stages);
  json["timings"] = {{"read", opened.read_seconds}, {"surface", opened.surface_seconds}};
  json["peak_memory_bytes"] = memory_peak();
  return text_of(json);
}

void summarize_provenance(const Input& input, const SurfaceFacts& surface, const PreparedSolver& solver,
                          std::ostream& out) {
  summarize_surface(input, surface, out);
  summarize_solver(solver, out);
}

}  // namespace geodrome
