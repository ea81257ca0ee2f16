// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "geodrome/conformance.hpp"
#include "geodrome/engine/plugin_text.hpp"

namespace geodrome::conformance {

namespace {

using Json = nlohmann::ordered_json;

const char* word(Outcome outcome) {
  constexpr const char* words[] = {"held", "failed", "not_applicable"};
  return words[static_cast<int>(outcome)];
}

Json object_of(const Verdict& verdict) {
  Json json = {{"demand", verdict.demand.name},
               {"sentence", verdict.demand.sentence},
               {"outcome", word(verdict.outcome)},
               {"seconds", verdict.seconds}};
  if (verdict.outcome == Outcome::not_applicable) json["why"] = verdict.found;
  if (verdict.outcome != Outcome::failed) return json;
  json["where"] = verdict.where, json["expected"] = verdict.expected, json["found"] = verdict.found;
  json["checks"] = verdict.checks, json["failures"] = verdict.failures;
  return json;
}

}  // namespace

std::string json_text(const Subject& subject, const std::vector<Verdict>& verdicts) {
  Json json = {{"plugin", Json::parse(geodrome::json_text(subject.plugin))}, {"options", subject.options}};
  for (const Outcome outcome : {Outcome::held, Outcome::failed, Outcome::not_applicable})
    json[word(outcome)] = std::ranges::count(verdicts, outcome, &Verdict::outcome);
  json["verdicts"] = Json::array();
  for (const Verdict& verdict : verdicts) json["verdicts"].push_back(object_of(verdict));
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace geodrome::conformance
