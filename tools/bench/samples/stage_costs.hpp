// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/plugin_host.hpp"

namespace geodrome::bench {

struct StageCost {
  std::string plugin;
  double seconds = 0;
  std::size_t peak = 0;  ///< bytes resident in the process, at most, while the stage ran: with what earlier ones left
};

/// Runs stages 1 to 4 one by one, as `make_surface` does, in one thread, and measures each. Throws what they throw.
std::vector<StageCost> stage_costs(const PointSample& sample, const PluginHost& host, const StageChoice& stages);

}  // namespace geodrome::bench
