// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geodrome/conformance.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "tools/conformance/record.hpp"

namespace geodrome::conformance {

/// A demand and the code that judges it.
struct JudgedDemand {
  const char *name, *sentence;
  void (*judge)(const Subject&, Record&);
};
using DemandTable = std::vector<JudgedDemand>;

/// Throws OptionError if the stage has no such demand.
JudgedDemand find_demand(const std::string& stage, const std::string& name);

/// The plugin under judgement, loaded, and the record: what a demand on `Stage` works with.
template <class Stage>
struct StageTrial : Record {
  const Subject& subject;
  PluginHost host;
  Plugin<Stage> plugin;

  explicit StageTrial(const Subject& judged)
      : subject(judged),
        host(judged.plugin_path),
        plugin(host.load<Stage>(judged.plugin.file.string() + (judged.options.empty() ? "" : ":" + judged.options))) {}
};

/// A row of a table: `judge_it` takes a trial, made anew for it.
template <class Trial, void (*judge_it)(Trial&)>
constexpr JudgedDemand demand(const char* name, const char* sentence) {
  return {name, sentence, [](const Subject& subject, Record& record) {
            Trial trial(subject);
            struct HandOver {
              Trial& trial;
              Record& record;
              ~HandOver() { record = trial; }  // what was recorded counts, however the demand ends
            } hand_over{trial, record};
            judge_it(trial);
          }};
}

DemandTable distance_demands();
DemandTable invariance_demands();
DemandTable guarantee_demands();
DemandTable request_demands();
DemandTable source_demands();
DemandTable path_demands();
DemandTable surface_demands();
DemandTable discipline_demands();
DemandTable lower_bound_demands();
DemandTable many_search_demands();
DemandTable weight_demands();
DemandTable pair_oracle_demands();
DemandTable tangent_demands();
DemandTable control_demands();
DemandTable decimator_demands();
DemandTable reconstructor_demands();
DemandTable inserter_demands();

}  // namespace geodrome::conformance
