// SPDX-License-Identifier: MIT
#include "engine/checks/stage_figures.hpp"

namespace geodrome {

namespace {

/// A figure and the stage that it is expected of.
struct Expected {
  const char *name, *stage;
};

constexpr Expected expected[] = {{"inconsistent_stars", SurfaceReconstructor::stage},
                                 {"star_ties", SurfaceReconstructor::stage},
                                 {"flips", SurfaceReconstructor::stage},
                                 {"lids", SurfaceReconstructor::stage},
                                 {"rounds", SurfaceReconstructor::stage},
                                 {"epsilon", SurfaceReconstructor::stage},
                                 {"sigma", TangentEstimator::stage},
                                 {"smoothed", TangentEstimator::stage},
                                 {"outliers", TangentEstimator::stage}};

}  // namespace

std::map<std::string, StageFigure> figures_of(const std::vector<StageRecord>& stages) {
  std::map<std::string, StageFigure> figures;
  for (const Expected& wanted : expected) {
    StageFigure& figure = figures[wanted.name];
    for (const StageRecord& stage : stages) {
      const auto found = stage.measures.find(wanted.name);
      const bool measured = found != stage.measures.end();
      if (measured) figure.value = found->second;
      if (measured || (!figure.is_measured() && stage.plugin.stage == wanted.stage))
        figure.by = stage.plugin.full_name();
    }
  }
  return figures;
}

}  // namespace geodrome
