// SPDX-License-Identifier: MIT
#include <chrono>
#include <exception>

#include "geodrome/plugin.hpp"
#include "tools/conformance/demand_table.hpp"

namespace geodrome::conformance {
namespace {

DemandTable joined(std::initializer_list<DemandTable> tables) {
  DemandTable all;
  for (const DemandTable& table : tables) all.insert(all.end(), table.begin(), table.end());
  return all;
}

DemandTable table_of(const std::string& stage) {
  if (stage == TangentEstimator::stage) return tangent_demands();
  if (stage == ControlFunction::stage) return control_demands();
  if (stage == Decimator::stage) return decimator_demands();
  if (stage == SurfaceReconstructor::stage) return joined({reconstructor_demands(), inserter_demands()});
  if (stage == ShortestPathSolver::stage)
    return joined({distance_demands(), guarantee_demands(), invariance_demands(), surface_demands(), request_demands(),
                   source_demands(), lower_bound_demands(), path_demands(), discipline_demands(), many_search_demands(),
                   weight_demands(), pair_oracle_demands()});
  throw OptionError("there is no stage '" + stage + "'");
}

/// What a demand that was left by an exception has to tell.
void blame(Verdict& verdict, const std::string& what) {
  verdict.outcome = Outcome::failed;
  if (verdict.failures++ > 0) return;
  verdict.expected = "no exception";
  verdict.found = what;
}

Verdict run(const JudgedDemand& demand, const Subject& subject) {
  Record record;
  Verdict verdict{{demand.name, demand.sentence}};
  std::string thrown;
  bool applies = true;
  try {
    demand.judge(subject, record);
  } catch (const NotApplicable& reason) {
    applies = false;
    verdict.found = reason.why;
  } catch (const std::exception& error) {
    thrown = error.what();
  } catch (...) {
    thrown = "an exception of unknown type";
  }
  verdict.checks = record.checks();
  verdict.failures = record.failures();
  if (verdict.failures > 0)
    verdict.expected = record.expected(), verdict.found = record.found(), verdict.where = record.where();
  if (!thrown.empty()) blame(verdict, "threw: " + thrown);
  if (applies && verdict.checks == 0 && thrown.empty()) blame(verdict, "the demand checked nothing");
  verdict.outcome = verdict.failures > 0 ? Outcome::failed : applies ? Outcome::held : Outcome::not_applicable;
  return verdict;
}

}  // namespace

std::vector<Demand> demands(const std::string& stage) {
  std::vector<Demand> all;
  for (const JudgedDemand& demand : table_of(stage)) all.push_back({demand.name, demand.sentence});
  return all;
}

JudgedDemand find_demand(const std::string& stage, const std::string& name) {
  for (const JudgedDemand& demand : table_of(stage))
    if (name == demand.name) return demand;
  throw OptionError("there is no demand '" + name + "' on a " + stage + " plugin");
}

Verdict judge(const Subject& subject, const std::string& name) {
  const JudgedDemand demand = find_demand(subject.plugin.stage, name);
  const auto start = std::chrono::steady_clock::now();
  Verdict verdict = run(demand, subject);
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace geodrome::conformance
