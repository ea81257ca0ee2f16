// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/smooth/fronts/edge_curves.hpp"
#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// What smooth distances are measured on, and the plugin that answers for it.
struct SmoothMetric {
  PluginInfo plugin;
  SmoothCharts charts;
  std::optional<EdgeCurves> curves;  ///< of `charts`; none where fronts cannot march: the mesh has no sides
  double around = 0;                 ///< how far around a point vertices may be that its distance is carried from

  SmoothMetric(PluginInfo by, SmoothCharts over) : plugin(std::move(by)), charts(std::move(over)) {
    if (!charts.mesh().manifold() || !charts.mesh().oriented()) return;
    curves.emplace(charts);
    for (Index f = 0; f < charts.mesh().face_count(); ++f)
      if (charts.trusts(f)) around = std::max(around, edges_around * charts.spacing(f));
  }
  SmoothMetric(const SmoothMetric&) = delete;
  SmoothMetric& operator=(const SmoothMetric&) = delete;

 private:
  static constexpr double edges_around = 3;  // corners of a face, and twice neighbours of those where ways meet
};

}  // namespace geodrome
