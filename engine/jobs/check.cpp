// SPDX-License-Identifier: MIT
#include "engine/jobs/check.hpp"

#include <ostream>

#include "engine/formats/text_stream.hpp"
#include "engine/input/finding_text.hpp"
#include "engine/report/weights_text.hpp"

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
  if (!input.file.empty()) out << input.file.string() << ": ";
  out << input.format << ", " << input.facts.rows << (mesh ? " vertices, " : " points, ");
  if (mesh) print_mesh(input, out);
  out << "diagonal " << input.facts.bounding_box_diagonal << "\n";
  if (!input.weights.empty()) out << "weights    " << weights_text(input) << "\n";
  print(input.findings, observer, out);
}

/// Stages 1 to 4 and what there is to tell of them.
void tell_sample(const JobStart& start, const Observer& observer, Json& json, std::ostream& text) {
  const Opened& opened = start.opened;
  const std::vector<Finding>& findings = opened.refusal ? opened.refusal->findings() : opened.surface.findings;
  json.update(to_json(*start.sample));
  json["findings"] = to_json(findings);
  json["stages"] = Json::array();
  for (const StageRecord& stage : opened.surface.stages) json["stages"].push_back(to_json(stage));
  if (opened.refusal)  // too little geometry to work on, as of an input that cannot be used
    json["error"] = {{"fault", name(InputFault::degenerate)},
                     {"message", opened.refusal->what()},
                     {"remedy", opened.refusal->remedy()}};
  print(findings, observer, text);
  SampleReport in_words = *start.sample;  // JSON has the sentences of the library
  if (opened.refusal) in_words.refusal->remedy = observer.words(opened.refusal->coded_remedy());
  print_full(in_words, text);
}

}  // namespace

CheckReport check_report(const JobStart& start, const Observer& observer) {
  CheckReport result{.refusal = start.opened.refusal};
  TextOutput text;
  text.precision(4);
  Json json{{"usable", true}, {"input", to_json(start.input())}};
  print(start.input(), observer, text);
  if (start.sample) tell_sample(start, observer, json, text);
  json["usable"] = !result.refusal;
  result.json = text_of(json), result.text = text.str();
  return result;
}

CheckReport run_check(const CheckJob& job, Observer& observer) {
  JobStart start{{.input = read_input(job.input, job.settings.read)}, std::nullopt};
  if (start.input().kind == InputKind::points && !job.input_only) {
    const PluginHost host(job.settings.plugin_path);
    start = start_quietly(std::move(start.opened.input), host, job.settings, std::nullopt, observer);
  }
  return check_report(start, observer);
}

std::string unusable_json(const std::filesystem::path& file, const InputError& error, const std::string& remedy) {
  const Json what{{"fault", name(error.fault())}, {"message", error.message()}, {"remedy", remedy}};
  return text_of(Json{{"usable", false}, {"file", file.string()}, {"error", what}});
}

}  // namespace geodrome
