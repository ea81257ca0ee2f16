// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <optional>

#include "engine/host/stage_context.hpp"
#include "engine/jobs/pairs/index.hpp"
#include "engine/jobs/start.hpp"
#include "engine/search/many_searches.hpp"

namespace geodrome {

/// What a Session holds and the jobs with a solver stand on, so that all of them take the same steps in the same order:
/// load the solver and ask what it provides, read the input, run stages 1 to 4, prepare the solver with the first
/// question. `prepared`, `planned` and `oracle` may be called from several threads at once.
class SessionState {
 public:
  /// Loads the solver. Throws as `load_solver`. `observer` must outlive it.
  SessionState(RunSettings settings, Observer& observer, Provides demands)
      : settings(std::move(settings)),
        observer(observer),
        host(this->settings.plugin_path),
        plugin(load_solver(host, this->settings.stages.solver,
                           this->settings.metric == Metric::smooth ? demands | Provides::paths : demands)) {}

  /// Runs stages 1 to 4 on a file or an Input. A sample that a stage refuses is kept in `start`: see
  /// `throw_if_refused`.
  template <class Source>
  void begin(Source&& source) {
    start = start_job(std::forward<Source>(source), host, settings, plugin.factor, observer);
  }

  /// The solver with the surface prepared: by the first call, or the next one if that throws.
  const PreparedSolver& prepared() {
    const std::lock_guard lock(preparing_);
    if (solver_.prepared) return solver_;
    PreparedSolver solver = prepare_solver(plugin, start.surface().mesh, host, settings, observer);
    solver.smooth = metric_of(start.surface());
    solver_ = std::move(solver);
    return solver_;
  }

  /// The solver ready for the rows of a plan: by the first call with that plan, or the next one if that throws, and
  /// until a call with another one.
  PreparedSolver planned(const RowPlan& plan) {
    const PreparedSolver& solver = prepared();
    const std::lock_guard lock(planning_);
    if (planned_ && plan == plan_) return *planned_;
    planned_.reset();
    StageContext planning = context(ShortestPathSolver::stage, thread_count(settings));
    plan_ = plan;
    planned_ = prepare_plan(solver, plan, planning).solver;
    return *planned_;
  }

  /// The oracle of the solver, which measures on the triangles, from the index file if one is named and there, else
  /// built: by the first call, which alone regards `index`, or the next one if that throws. Throws as
  /// `demand_pair_queries` and `ready_oracle`.
  const ReadyOracle& oracle(const std::filesystem::path& index = {}) {
    const std::lock_guard lock(building_);
    if (oracle_.oracle) return oracle_;
    demand_pair_queries(plugin.info, host);
    oracle_ = ready_oracle(*start.surface().mesh, prepared(), index, settings, observer);
    return oracle_;
  }

  StageContext context(const char* stage, unsigned threads) const {
    return StageContext(stage, observer, threads, settings.seed);
  }

  const RunSettings settings;
  Observer& observer;
  const PluginHost host;
  const SolverPlugin plugin;
  JobStart start;

 private:
  std::mutex preparing_, planning_, building_;
  PreparedSolver solver_;
  std::optional<PreparedSolver> planned_;  // for plan_
  RowPlan plan_;
  ReadyOracle oracle_;
};

}  // namespace geodrome
