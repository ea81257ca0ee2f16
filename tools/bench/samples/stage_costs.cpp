// SPDX-License-Identifier: MIT
#include "tools/bench/samples/stage_costs.hpp"

#include <chrono>

#include "engine/report/memory.hpp"

namespace geodrome::bench {
namespace {

/// Calls a stage, of which `function` gets the object and a context.
template <class Stage, class Function>
auto measure(const std::string& selection, const PluginHost& host, std::vector<StageCost>& costs, Function&& function) {
  const Plugin<Stage> plugin = host.load<Stage>(selection);
  QuietContext context;
  reset_memory_peak();
  const auto start = std::chrono::steady_clock::now();
  auto result = plugin.call([&](const Stage& stage) { return function(stage, context); });
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  costs.push_back({plugin.info.full_name(), seconds, memory_peak()});
  return result;
}

}  // namespace

std::vector<StageCost> stage_costs(const PointSample& sample, const PluginHost& host, const StageChoice& stages) {
  std::vector<StageCost> costs;
  const Tangents tangents = measure<TangentEstimator>(
      stages.tangent, host, costs,
      [&](const TangentEstimator& stage, RunContext& context) { return stage.estimate(sample, context); });
  PointSample origins = sample;
  for (std::size_t i = 0; i < origins.size(); ++i)
    if (tangents.state[i] != PointState::dropped) origins.points[i] = tangents.plane[i].origin;
  const Control control = measure<ControlFunction>(
      stages.control, host, costs,
      [&](const ControlFunction& stage, RunContext& context) { return stage.evaluate(origins, tangents, context); });
  const std::vector<Index> kept = measure<Decimator>(
      stages.decimator, host, costs,
      [&](const Decimator& stage, RunContext& context) { return stage.select(origins, control, context); });
  measure<SurfaceReconstructor>(stages.reconstructor, host, costs,
                                [&](const SurfaceReconstructor& stage, RunContext& context) {
                                  return stage.reconstruct(origins, tangents, control, kept, context);
                                });
  return costs;
}

}  // namespace geodrome::bench
