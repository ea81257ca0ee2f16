// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/smooth.hpp"

#include "engine/search/distances.hpp"
#include "engine/search/rows.hpp"

namespace geodrome {

SmoothMeasurement measure_smooth(const ComparedSurface& on, PreparedSolver solver, const RunSettings& settings,
                                 const std::string& name, Observer& observer) {
  solver.smooth = on.metric;
  WithoutProgress quiet(observer);
  StageContext context(name, observer, 1, settings.seed), within(name, quiet, 1, settings.seed);
  const auto search = make_search(solver);
  SmoothMeasurement measured;
  for (std::size_t i = 0; i < on.sources.size(); ++i) {
    std::vector<double>& row = measured.rows.emplace_back(on.targets.size());
    const Stopwatch watch;
    const ShortestPathMap* map =
        distance_row(solver, *search, on.sources[i], on.targets, infinity, within, row, Keep::map);
    if (map) measured.paths.add(smooth_row(solver, *map, on.sources[i], on.targets, infinity, row));
    measured.source_seconds.push_back(watch.seconds());
    context.throw_if_cancelled();
    context.progress(static_cast<double>(i + 1) / static_cast<double>(on.sources.size()));
  }
  return measured;
}

}  // namespace geodrome
