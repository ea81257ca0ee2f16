// SPDX-License-Identifier: MIT
#pragma once

#include "engine/smooth/fronts/edge_curves.hpp"
#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// What smooth distances are measured on, and the plugin that answers for it.
struct SmoothMetric {
  PluginInfo plugin;
  SmoothCharts charts;
  std::optional<EdgeCurves> curves;  ///< of `charts`; none where fronts cannot march: the mesh has no sides

  SmoothMetric(PluginInfo by, SmoothCharts over) : plugin(std::move(by)), charts(std::move(over)) {
    if (charts.mesh().manifold() && charts.mesh().oriented()) curves.emplace(charts);
  }
  SmoothMetric(const SmoothMetric&) = delete;
  SmoothMetric& operator=(const SmoothMetric&) = delete;
};

}  // namespace geodrome
