// SPDX-License-Identifier: MIT
#include "engine/search/distances.hpp"

#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/search/reach.hpp"
#include "engine/search/traced_path.hpp"

namespace geodrome {

namespace {

/// The sources that a search can start from, and which of the user's they are.
struct Starts {
  std::vector<Source> sources;
  std::vector<Index> of_user;
};

Starts starts_of(std::span<const NamedPoint> sources) {
  Starts starts;
  for (Index i = 0; i < sources.size(); ++i) {
    if (sources[i].place.state != Place::State::on_surface) continue;
    starts.sources.push_back({sources[i].place.at, sources[i].start});
    starts.of_user.push_back(i);
  }
  return starts;
}

/// The nearest of the sources that need no search: a vertex on no face to itself.
Distance without_search(std::span<const NamedPoint> sources, const NamedPoint& target, const DistanceRule& rule) {
  Distance best;
  for (Index i = 0; i < sources.size(); ++i) {
    const double along = surface_distance(sources[i].place, target.place, [] { return infinity; });
    const double d = rule(along + sources[i].start, sources[i], target);
    if (std::isfinite(along) && best.reach != Reach::reached) best.reach = Reach::beyond_limit;
    if (d < best.value) best = {d, Reach::reached, i};
  }
  return best;
}

/// The nearest source of a target on the surface, by a map of all of them.
Distance by_search(const ShortestPathMap& map, const Starts& starts, std::span<const NamedPoint> sources,
                   const NamedPoint& target, const DistanceRule& rule) {
  const Distance found = map.at(target.place.at);
  if (!is_distance(found.value)) throw_no_distance(found.value, "target " + target.label);
  if ((found.reach == Reach::reached) != std::isfinite(found.value))
    throw NumericalError("said " + std::string(reach_word(found.value, found.reach, target.place)) + " of target " +
                             target.label + ", whose distance it gives as " + number_text(found.value),
                         "choose another solver, and report this to the author of the plugin");
  if (found.reach != Reach::reached) return {found.value, found.reach, no_index};
  if (found.source >= starts.sources.size())
    throw NumericalError("named no source for target " + target.label,
                         "choose another solver, and report this to the author of the plugin");
  const Index source = starts.of_user[found.source];
  const double d = rule(found.value, sources[source], target);
  return std::isinf(d) ? Distance{d, Reach::beyond_limit, no_index} : Distance{d, Reach::reached, source};
}

/// By the map of a search from that source alone; null where none is needed.
void read_row(const ShortestPathMap* map, const NamedPoint& source, const TargetList& targets, double max_distance,
              Reading reading, std::span<double> row) {
  const DistanceRule rule{targets.bounded(), max_distance};
  for (std::size_t j = 0; j < row.size(); ++j) {
    const NamedPoint& target = targets.named()[j];
    const bool reads = reading == Reading::all || target.place.vertex != no_index;
    const double along = surface_distance(source.place, target.place, [&] {
      if (!map) return infinity;
      return reads ? targets.read(*map, j) : 0;
    });
    row[j] = rule(along + source.start, source, target);
  }
}

}  // namespace

void throw_no_distance(double value, const std::string& whose) {
  throw NumericalError("computed " + number_text(value) + " as the distance of " + whose,
                       "choose another solver, and report this to the author of the plugin");
}

const ShortestPathMap* distance_row(const PreparedSolver& solver, Search& search, const NamedPoint& source,
                                    const TargetList& targets, double max_distance, RunContext& context,
                                    std::span<double> row, Keep keep, Reading reading) {
  // With a single source its start distance only shifts the row, so no solver needs to know of it.
  const double radius = max_distance - source.start;
  const ShortestPathMap* map = nullptr;
  if (source.place.state == Place::State::on_surface && radius >= 0) {
    const Source from{source.place.at, 0};
    const Request request{.radius = radius, .targets = targets.points(), .keep = keep};
    map = &run_search(solver, search, {&from, 1}, request, context);
  }
  cross_boundary(solver.plugin.info, [&] { read_row(map, source, targets, max_distance, reading, row); });
  return map;
}

std::vector<Distance> nearest_distances(const PreparedSolver& solver, std::span<const NamedPoint> sources,
                                        const TargetList& targets, double max_distance, RunContext& context,
                                        const WatchNearest& watch, Keep keep) {
  if (std::ranges::any_of(sources, [](const NamedPoint& source) { return source.start > 0; }))
    demand(solver.plugin.info, Provides::start_distances);
  const DistanceRule rule{targets.bounded(), max_distance};
  const Starts starts = starts_of(sources);
  const auto search = make_search(solver);
  const ShortestPathMap* map = nullptr;
  const Request request{.radius = max_distance, .targets = targets.points(), .keep = keep};
  if (!starts.sources.empty()) map = &run_search(solver, *search, starts.sources, request, context);
  std::vector<Distance> nearest;
  for (const NamedPoint& target : targets.named()) {
    if (!target.place.has_distances())
      nearest.push_back({not_computed, Reach::unreachable, no_index});
    else if (target.place.state == Place::State::isolated || !map)
      nearest.push_back(without_search(sources, target, rule));
    else
      nearest.push_back(
          cross_boundary(solver.plugin.info, [&] { return by_search(*map, starts, sources, target, rule); }));
  }
  if (watch) watch(map, nearest);
  return nearest;
}

double searched_distance(const PreparedSolver& solver, Search& search, const Place& from, const Place& to,
                         RunContext& context) {
  const Source source{from.at, 0};
  const Request request{.targets = {&to.at, 1}, .stop_at_targets = solver.provides(Provides::target_limit)};
  const ShortestPathMap& map = run_search(solver, search, {&source, 1}, request, context);
  return cross_boundary(solver.plugin.info, [&] { return map.at(to.at).value; });
}

double pair_distance(const PairOracle& oracle, const NamedPair& pair, std::size_t number) {
  return surface_distance(pair.from.place, pair.to.place, [&] {
    const double value = oracle.distance(pair.from.place.at, pair.to.place.at);
    if (!is_distance(value))
      throw_no_distance(value, "pair " + std::to_string(number) + " (" + pair.from.label + ", " + pair.to.label + ")");
    return value;
  });
}

PathResult shortest_path(const PreparedSolver& solver, const SurfaceMesh& mesh, const NamedPoint& from,
                         const TargetList& to, RunContext& context) {
  const NamedPoint& end = to.named()[0];
  const auto search = make_search(solver);
  const ShortestPathMap* map = nullptr;
  const double along = surface_distance(from.place, end.place, [&] {
    const Source source{from.place.at, 0};
    const Request request{
        .targets = {&end.place.at, 1}, .stop_at_targets = solver.provides(Provides::target_limit), .keep = Keep::map};
    map = &run_search(solver, *search, {&source, 1}, request, context);
    return cross_boundary(solver.plugin.info, [&] { return to.read(*map, 0); });
  });
  PathResult path;
  if (map && std::isfinite(along)) path = trace_path(solver, *map, end.place.at, mesh);
  // A path is real: one that is shorter than the distance is nearer to the true one.
  const bool is_better = !path.points.empty() && path.length < along && !solver.provides(Provides::path_is_distance);
  path.distance = DistanceRule{to.bounded()}(is_better ? path.length : along, {from.place}, end);
  return path;
}

}  // namespace geodrome
