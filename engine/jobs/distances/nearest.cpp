// SPDX-License-Identifier: MIT
#include "engine/jobs/distances/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/search/distances.hpp"
#include "engine/search/lower_bounds.hpp"
#include "engine/search/reach.hpp"

namespace geodrome {

namespace {

void count(NearestResult& result) {
  for (const Distance& d : result.distances)
    ++(std::isnan(d.value)              ? result.dropped
       : d.reach == Reach::reached      ? result.reached
       : d.reach == Reach::beyond_limit ? result.beyond_limit
                                        : result.unreachable);
}

/// The lower bounds of what a search from all sources gave; of what needed no search the distance itself, or the limit.
std::vector<double> bounds_of(const PreparedSolver& solver, const ShortestPathMap* map,
                              std::span<const NamedPoint> sources, const TargetList& targets,
                              std::span<const Distance> nearest, double max_distance) {
  const bool factor_holds =
      std::ranges::all_of(sources, [&](const NamedPoint& source) { return solver.states_factor_at(source.place); });
  std::vector<double> bounds;
  for (std::size_t j = 0; j < nearest.size(); ++j) {
    const Place& place = targets.named()[j].place;
    const Distance& given = nearest[j];
    if (map && place.state == Place::State::on_surface)
      bounds.push_back(lower_bound(solver, *map, factor_holds, place, map->at(place.at).value, max_distance));
    else
      bounds.push_back(given.reach == Reach::beyond_limit ? max_distance : given.value);
  }
  return bounds;
}

}  // namespace

NearestResult find_nearest(const PreparedSolver& solver, const SurfaceMesh& mesh, std::span<const NamedPoint> sources,
                           const TargetList& targets, double max_distance, bool with_bounds, RunContext& context) {
  NearestResult result;
  const auto watch = [&](const ShortestPathMap* map, std::span<const Distance> nearest) {
    if (map) {
      const auto found = cross_boundary(solver.plugin.info, [&] { return map->vertices(); });
      result.vertices.assign(found.begin(), found.end());
      result.certified = audit_intervals(solver, mesh, *map);
    }
    if (with_bounds)
      cross_boundary(solver.plugin.info,
                     [&] { result.bounds = bounds_of(solver, map, sources, targets, nearest, max_distance); });
  };
  const Stopwatch stopwatch;
  static_cast<MeasuredNearest&>(result) = measured_nearest(solver, sources, targets, max_distance, context, watch);
  result.seconds = stopwatch.seconds();
  count(result);
  return result;
}

std::string as_csv(const NearestResult& nearest, std::span<const NamedPoint> sources,
                   std::span<const NamedPoint> targets) {
  const bool with_bounds = !nearest.bounds.empty();
  std::string text = std::string("target,distance,source,reach") + (with_bounds ? ",lower_bound" : "") + "\n";
  for (std::size_t j = 0; j < targets.size(); ++j) {
    const Distance& d = nearest.distances[j];
    text += targets[j].label + "," + number_text(d.value) + "," +
            (d.source == no_index ? "" : sources[d.source].label) + "," +
            reach_word(d.value, d.reach, targets[j].place) + (with_bounds ? "," + number_text(nearest.bounds[j]) : "") +
            "\n";
  }
  return text;
}

}  // namespace geodrome
