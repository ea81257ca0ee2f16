// SPDX-License-Identifier: MIT
#pragma once

#include "engine/smooth/charts.hpp"
#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// What smooth distances are measured on, and the plugin that answers for it.
struct SmoothMetric {
  PluginInfo plugin;
  SmoothCharts charts;
};

}  // namespace geodrome
