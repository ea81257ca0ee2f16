// SPDX-License-Identifier: MIT
#include "tools/conformance/verdict_json.hpp"

namespace geodrome::conformance {

nlohmann::json to_json(const Verdict& verdict) {
  return {{"demand", verdict.demand.name},
          {"sentence", verdict.demand.sentence},
          {"outcome", static_cast<int>(verdict.outcome)},
          {"expected", verdict.expected},
          {"found", verdict.found},
          {"where", verdict.where},
          {"checks", verdict.checks},
          {"failures", verdict.failures},
          {"seconds", verdict.seconds}};
}

Verdict verdict_from_json(const nlohmann::json& json) {
  Verdict verdict;
  json.at("demand").get_to(verdict.demand.name);
  json.at("sentence").get_to(verdict.demand.sentence);
  verdict.outcome = static_cast<Outcome>(json.at("outcome").get<int>());
  json.at("expected").get_to(verdict.expected);
  json.at("found").get_to(verdict.found);
  json.at("where").get_to(verdict.where);
  json.at("checks").get_to(verdict.checks);
  json.at("failures").get_to(verdict.failures);
  json.at("seconds").get_to(verdict.seconds);
  return verdict;
}

}  // namespace geodrome::conformance
