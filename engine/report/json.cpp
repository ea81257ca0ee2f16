// SPDX-License-Identifier: MIT
#include "engine/report/json.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome {

namespace {

using geodrome::to_json;  // the overloads below would hide them

const char* word(Finding::Severity severity) {
  switch (severity) {
    case Finding::Severity::note:
      return "note";
    case Finding::Severity::warning:
      return "warning";
    default:
      return "refusal";
  }
}

const char* word(OptionType type) {
  constexpr const char* names[] = {"boolean", "integer", "number", "choice"};
  return names[static_cast<int>(type)];
}

Json to_json(const std::optional<long>& value) { return value ? Json(*value) : Json(nullptr); }

Json to_json(const OptionInfo& option) {
  Json json{{"name", option.name}, {"type", word(option.type)}, {"default", option.default_value}};
  if (option.type == OptionType::integer || option.type == OptionType::number) {
    json["minimum"] = to_json(option.minimum);
    json["maximum"] = to_json(option.maximum);
  } else {
    json["choices"] = option.choices;
  }
  json["unit"] = option.unit;
  json["help"] = option.help;
  return json;
}

Json weights_json(const Input& input) {
  if (input.weights.empty()) return nullptr;
  const auto [smallest, largest] = std::ranges::minmax(input.weights);
  return {{"from", input.weights_from}, {"hash", input.weights_hash}, {"smallest", smallest}, {"largest", largest}};
}

}  // namespace

Json to_json(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

Json to_json(const Finding& finding) {
  Json json{{"severity", word(finding.severity)},
            {"code", finding.code},
            {"message", finding.message},
            {"count", finding.count},
            {"elements", finding.elements}};
  if (!finding.remedy.empty()) json["remedy"] = finding.remedy.text;
  if (!finding.remedy.code.empty()) json["remedy_code"] = finding.remedy.code;
  return json;
}

Json to_json(const std::vector<Finding>& findings) {
  Json json = Json::array();
  for (const Finding& finding : findings) json.push_back(to_json(finding));
  return json;
}

Json to_json(const Input& input) {
  const InputFacts& f = input.facts;
  Json json{{"file", input.file.string()},
            {"format", input.format},
            {"hash", input.hash},
            {"kind", input.kind == InputKind::mesh ? "mesh" : "points"},
            {"rows", f.rows},
            {"used", input.positions.size()},
            {"merged", f.merged},
            {"dropped", f.dropped},
            {"bounding_box_diagonal", f.bounding_box_diagonal}};
  if (input.kind == InputKind::mesh)
    json.update(Json{{"faces_in_file", f.faces_in_file},
                     {"triangles", input.triangles.size()},
                     {"weights", weights_json(input)},
                     {"polygons_split", f.polygons_split},
                     {"degenerate_faces_dropped", f.degenerate_faces_dropped},
                     {"zero_area_faces", f.zero_area_faces},
                     {"duplicate_faces", f.duplicate_faces},
                     {"duplicate_positions", f.duplicate_positions},
                     {"isolated_vertices", f.isolated_vertices},
                     {"nonmanifold_edges", f.nonmanifold_edges},
                     {"nonmanifold_vertices", f.nonmanifold_vertices},
                     {"manifold", f.manifold},
                     {"oriented", f.oriented},
                     {"orientable", f.orientable},
                     {"components", f.components},
                     {"boundary_edges", f.boundary_edges},
                     {"boundary_loops", f.boundary_loops},
                     {"euler_number", to_json(f.euler_number)},
                     {"genus", to_json(f.genus)}});
  json["findings"] = to_json(input.findings);
  return json;
}

Json to_json(const PluginInfo& plugin) {
  Json json{{"stage", plugin.stage},
            {"name", plugin.name},
            {"summary", plugin.summary},
            {"licence", plugin.licence},
            {"file", plugin.file.string()}};
  if (plugin.stage == ShortestPathSolver::stage) {
    json["factor"] = to_json(plugin.default_factor);
    json["needs"] = words_of(plugin.needs);
    json["provides"] = words_of(plugin.provides);
  }
  json["options"] = Json::array();
  for (const OptionInfo& option : plugin.options) json["options"].push_back(to_json(option));
  return json;
}

Json to_json(const PluginListing& listing) {
  Json json{{"usable", Json::array()}, {"refused", Json::array()}};
  for (const PluginInfo& plugin : listing.usable) json["usable"].push_back(to_json(plugin));
  for (const PluginRefusal& refusal : listing.refused)
    json["refused"].push_back({{"file", refusal.file.string()}, {"reason", refusal.reason}});
  return json;
}

Json to_json(const StageRecord& record) {
  Json json{{"plugin", record.plugin.full_name()}, {"licence", record.plugin.licence},
            {"file", record.plugin.file.string()}, {"options", Json::object()},
            {"seconds", record.seconds},           {"measures", Json::object()}};
  for (const auto& [name, value] : record.options.all()) json["options"][name] = value;
  for (const auto& [name, value] : record.measures) json["measures"][name] = to_json(value);
  return json;
}

}  // namespace geodrome
