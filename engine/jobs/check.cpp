// SPDX-License-Identifier: MIT
#include <ostream>
#include <sstream>

#include "engine/input/finding_text.hpp"
#include "engine/report/sample_report.hpp"
#include "engine/report/weights_text.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

namespace {

void print_mesh(const Input& input, std::ostream& out) {
  const InputFacts& f = input.facts;
  out << input.triangles.size() << " triangles, " << f.components
      << (f.components == 1 ? " component, " : " components, ") << f.boundary_loops
      << (f.boundary_loops == 1 ? " boundary loop, " : " boundary loops, ")
      << (f.manifold ? "manifold, " : "nonmanifold, ")
      << (f.oriented     ? "oriented, "
          : f.orientable ? "not oriented, "
                         : "not orientable, ");
  if (f.genus) out << "genus " << *f.genus << ", ";
}

void print(const std::vector<Finding>& findings, const Observer& observer, std::ostream& out) {
  for (const Finding& finding : findings)
    out << (finding.severity == Finding::Severity::note ? "note: " : "warning: ") << text_of(finding, observer) << "\n";
}

void print(const Input& input, const Observer& observer, std::ostream& out) {
  const bool mesh = input.kind == InputKind::mesh;
  out << input.file.string() << ": " << input.format << ", " << input.facts.rows
      << (mesh ? " vertices, " : " points, ");
  if (mesh) print_mesh(input, out);
  out << "diagonal " << input.facts.bounding_box_diagonal << "\n";
  if (!input.weights.empty()) out << "weights    " << weights_text(input) << "\n";
  print(input.findings, observer, out);
}

/// Stages 1 to 4 and what there is to tell of them.
void check_sample(const CheckJob& job, const Input& input, Observer& observer, Json& json, std::ostream& text,
                  CheckReport& result) {
  const PluginHost host(job.settings.plugin_path);
  const SurfaceAttempt attempt = try_surface(input, host, job.settings, observer);
  result.refusal = attempt.refusal;
  const SampleError* refusal = attempt.refusal ? &*attempt.refusal : nullptr;
  const SampleReport report = make_sample_report(input, attempt.surface, refusal, std::nullopt, job.settings.seed);
  const std::vector<Finding>& findings = refusal ? refusal->findings() : attempt.surface.findings;
  json.update(to_json(report));
  json["findings"] = to_json(findings);
  json["stages"] = Json::array();
  for (const StageRecord& stage : attempt.surface.stages) json["stages"].push_back(to_json(stage));
  if (refusal)  // too little geometry to work on, as of an input that cannot be used
    json["error"] = {
        {"fault", name(InputFault::degenerate)}, {"message", refusal->what()}, {"remedy", refusal->remedy()}};
  print(findings, observer, text);
  print_full(report, text);
}

}  // namespace

CheckReport run_check(const CheckJob& job, Observer& observer) {
  const Input input = read_input(job.input, job.settings.read);
  CheckReport result;
  std::ostringstream text;
  text.precision(4);
  Json json{{"usable", true}, {"input", to_json(input)}};
  print(input, observer, text);
  if (input.kind == InputKind::points && !job.input_only) check_sample(job, input, observer, json, text, result);
  json["usable"] = !result.refusal;
  result.json = text_of(json), result.text = text.str();
  return result;
}

std::string unusable_json(const std::filesystem::path& file, const InputError& error, const std::string& remedy) {
  const Json what{{"fault", name(error.fault())}, {"message", error.message()}, {"remedy", remedy}};
  return text_of(Json{{"usable", false}, {"file", file.string()}, {"error", what}});
}

}  // namespace geodrome
