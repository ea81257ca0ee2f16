// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/json.hpp"

#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/report/smooth_text.hpp"
#include "geodrome/engine/version.hpp"

namespace geodrome {

namespace {

using geodrome::to_json;  // the overloads below would hide them

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const ErrorSummary& summary) {
  const bool any = summary.compared > 0;
  return {{"compared", summary.compared},
          {"mean", any ? Json(summary.mean) : Json(nullptr)},
          {"max", any ? Json(summary.max) : Json(nullptr)}};
}

Json to_json(const ErrorFigures& errors) {
  const bool any = errors.all.compared > 0;
  Json json{{"compared", errors.all.compared},
            {"max_over", any ? to_json(errors.max_over) : Json(nullptr)},
            {"max_under", any ? to_json(errors.max_under) : Json(nullptr)},
            {"mean", any ? to_json(errors.all.mean) : Json(nullptr)},
            {"quantiles", Json::object()}};
  for (std::size_t i = 0; i < std::size(ErrorFigures::shares); ++i)
    json["quantiles"][number_text(ErrorFigures::shares[i])] = any ? Json(errors.quantiles[i]) : Json(nullptr);
  json["near"] = to_json(errors.near), json["far"] = to_json(errors.far);
  json["histogram"] = {
      {"decades", errors.histogram.decades}, {"counts", errors.histogram.counts}, {"zero", errors.histogram.zero}};
  return json;
}

Json to_json(const NamedCheck& named) {
  const InvariantCheck& check = named.check;
  return {{"name", named.name},
          {"holds", check.tested > 0 ? Json(check.violated == 0) : Json(nullptr)},
          {"worst", finite_or_null(check.worst)},
          {"promised", check.expected}};
}

Json to_json(const GuaranteeFigures& guarantee) {
  return {{"stated", or_null(guarantee.stated)},
          {"worst", or_null(guarantee.worst)},
          {"held", or_null(guarantee.held)},
          {"why", guarantee.why}};
}

Json to_json(const std::vector<NamedCheck>& invariants) {
  Json json = Json::array();
  for (const NamedCheck& check : invariants) json.push_back(to_json(check));
  return json;
}

Json to_json(const SmoothComparison& smooth) {
  Json json = to_json(smooth.paths);
  json["seconds"] = {{"per_source", smooth.median_seconds()}, {"sources", smooth.source_seconds}};
  json["errors"] = to_json(smooth.errors);
  json["reach_differs"] = smooth.errors.reach_differs;
  json["unreachable"] = smooth.errors.unreachable;
  json["invariants"] = to_json(smooth.invariants);
  return json;
}

Json counters_json(const std::map<std::string, double>& counters) {
  Json json = Json::object();
  for (const auto& [name, value] : counters) json[name] = value;
  return json;
}

Json to_json(const GrowthStep& step) {
  return {{"rows", step.rows},
          {"vertices", step.cost.vertices},
          {"faces", step.cost.faces},
          {"prepare", step.cost.prepare_seconds},
          {"per_source", step.cost.median_seconds()},
          {"peak_bytes", or_null(step.cost.peak_bytes)},
          {"counters", counters_json(step.cost.counters)}};
}

Json seconds_json(const CombinationFigures& combination) {
  Json stages = Json::object();
  for (const auto& [stage, seconds] : combination.stage_seconds) stages[stage] = seconds;
  const SearchCost& cost = combination.cost;
  return {{"stages", stages},
          {"prepare", cost.prepare_seconds},
          {"per_source", cost.median_seconds()},
          {"sources", cost.source_seconds}};
}

Json to_json(const CombinationFigures& combination) {
  Json json{{"name", combination.name}, {"stages", Json::object()}, {"error", nullptr}};
  for (const auto& [stage, choice] : combination.stages) json["stages"][stage] = choice;
  if (!combination.ran()) {
    json["error"] = {{"text", combination.error}, {"status", combination.error_status}};
    return json;
  }
  const SearchCost& cost = combination.cost;
  json["factor"] = finite_or_null(combination.factor);
  json["never_shorter"] = combination.never_shorter;
  json["surface"] = {{"vertices", cost.vertices}, {"faces", cost.faces}};
  json["seconds"] = seconds_json(combination);
  json["memory"] = {{"peak_bytes", or_null(cost.peak_bytes)}, {"prepared_bytes", cost.prepared_bytes}};
  json["errors"] = to_json(combination.errors);
  if (const auto& certified = combination.certified)
    json["certified"] = {{"largest", to_json(certified->largest)},
                         {"mean", to_json(certified->mean())},
                         {"worst", to_json(certified->worst)}};
  json["reach_differs"] = combination.errors.reach_differs;
  json["unreachable"] = combination.errors.unreachable;
  json["invariants"] = to_json(combination.invariants);
  json["guarantee"] = to_json(combination.guarantee);
  if (combination.smooth) json["smooth"] = to_json(*combination.smooth);
  json["counters"] = counters_json(cost.counters);
  json["growth"] = Json::array();
  for (const GrowthStep& step : combination.growth) json["growth"].push_back(to_json(step));
  return json;
}

Json to_json(const ComparedSource& source) {
  const Vec3& p = source.position;
  Json json{{"entry", source.entry}, {"row", or_null(source.row)}, {"position", {p.x, p.y, p.z}}};
  if (source.off_surface > 0) json["off_surface"] = source.off_surface;
  return json;
}

}  // namespace

Json to_json(const ComparisonFigures& figures) {
  const bool is_mesh = figures.kind == InputKind::mesh;
  Json json{{"schema", "geodrome-comparison/1"}, {"version", version()}};
  json["input"] = {{"file", figures.file},
                   {"kind", is_mesh ? "mesh" : "points"},
                   {"rows", figures.rows},
                   {"faces", is_mesh ? Json(figures.faces) : Json(nullptr)},
                   {"diagonal", figures.diagonal}};
  json["sources"] = Json::array();
  for (const ComparedSource& source : figures.sources) json["sources"].push_back(to_json(source));
  json["targets"] = figures.rows;
  json["truth"] = {{"kind", figures.truth.kind}, {"name", figures.truth.name}, {"text", figures.truth.text}};
  json["near"] = near_share, json["far"] = far_share;
  json["combinations"] = Json::array();
  for (const CombinationFigures& combination : figures.combinations)
    json["combinations"].push_back(to_json(combination));
  return json;
}

}  // namespace geodrome
