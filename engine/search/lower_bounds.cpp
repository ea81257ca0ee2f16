// SPDX-License-Identifier: MIT
#include "engine/search/lower_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/remedies.hpp"
#include "engine/search/distances.hpp"

namespace geodrome {

bool has_lower_bounds(const Plugin<ShortestPathSolver>& solver) {
  return std::isfinite(solver.factor) || StatedBounds(solver);
}

void demand_lower_bounds(const Plugin<ShortestPathSolver>& solver) {
  if (!has_lower_bounds(solver))
    throw CapabilityError(solver.info.full_name() + " gives no lower bounds: it states neither bounds nor a factor",
                          remedies::solver_with_bounds());
}

void check_bounds_metric(Metric metric) {
  if (metric == Metric::smooth)
    throw OptionError(
        "what solvers prove are lower bounds of distances on the triangles; of smooth ones there is none but the "
        "straight line",
        remedies::flat_metric());
}

double lower_bound(const PreparedSolver& solver, const ShortestPathMap& map, bool source_has_factor, const Place& to,
                   double found, double radius) {
  if (const StatedBounds stated(solver.plugin); stated) {
    const double bound = stated.at(map, to.at);
    if (!is_distance(bound)) throw_no_distance(bound, "a lower bound");
    return std::min(bound, found);
  }
  if (found == infinity && map.at(to.at).reach == Reach::unreachable) return infinity;
  const bool holds = source_has_factor && solver.states_factor_at(to);
  return holds ? std::min(found, radius) / solver.plugin.factor : 0;
}

void read_lower_bounds(const PreparedSolver& solver, const ShortestPathMap* map, const NamedPoint& source,
                       const TargetList& targets, double max_distance, std::span<const double> row,
                       std::span<double> bounds) {
  const DistanceRule rule{targets.bounded()};
  const bool source_has_factor = solver.states_factor_at(source.place);
  const double radius = max_distance - source.start;
  for (std::size_t j = 0; j < row.size(); ++j) {
    const NamedPoint& target = targets.named()[j];
    const double along = surface_distance(source.place, target.place, [&] {
      // A source that starts beyond the limit is not searched from.
      return map ? lower_bound(solver, *map, source_has_factor, target.place, targets.read(*map, j), radius) : 0;
    });
    const double bound = rule(along + source.start, source, target);
    bounds[j] = bound > row[j] ? row[j] : bound;
  }
}

}  // namespace geodrome
