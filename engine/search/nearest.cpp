// SPDX-License-Identifier: MIT
#include "engine/search/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/host/stage_context.hpp"

namespace geodrome {

namespace {

const char* word(Reach reach) {
  switch (reach) {
    case Reach::reached:
      return "reached";
    case Reach::beyond_limit:
      return "beyond_limit";
    default:
      return "unreachable";
  }
}

/// The sources that a search can start from, and which of the user's they are.
struct Starts {
  std::vector<Source> sources;
  std::vector<Index> of_query;
};

Starts starts_of(const PreparedSolver& solver, std::span<const NamedPoint> queries) {
  Starts starts;
  for (Index i = 0; i < queries.size(); ++i) {
    if (queries[i].place.state != Place::State::on_surface) continue;
    starts.sources.push_back({queries[i].place.at, queries[i].start});
    starts.of_query.push_back(i);
  }
  if (std::any_of(queries.begin(), queries.end(), [](const NamedPoint& q) { return q.start > 0; }))
    demand(solver, Provides::start_distances, "start distances (start_distances)");
  return starts;
}

/// A vertex that no face uses is reached only by itself, whatever the solver does.
Distance at_isolated(const Place& place, std::span<const NamedPoint> sources) {
  Distance best;
  for (Index i = 0; i < sources.size(); ++i) {
    const Place& from = sources[i].place;
    if (from.state != Place::State::isolated || from.vertex != place.vertex || !(sources[i].start < best.value))
      continue;
    best = {sources[i].start, Reach::reached, i};
  }
  return best;
}

Distance at_surface(const PreparedSolver& solver, const ShortestPathMap& map, const Starts& starts,
                    std::span<const NamedPoint> sources, const TargetList& targets, std::size_t j) {
  Distance found = cross_boundary(solver.plugin.info, [&] {
    const Distance d = map.at(targets.queries()[j].place.at);
    if (!(d.value >= 0) || (d.reach == Reach::reached && d.source >= starts.sources.size()))
      throw NumericalError("gave no valid distance for target " + targets.queries()[j].label);
    return d;
  });
  found.source = found.reach == Reach::reached ? starts.of_query[found.source] : no_index;
  if (found.source == no_index) return found;
  const NamedPoint& source = sources[found.source];
  found.value = std::max(found.value, targets.lower_bound(source, j) + source.start);
  return found;
}

}  // namespace

NearestResult find_nearest(const PreparedSolver& solver, std::span<const NamedPoint> sources, const TargetList& targets,
                           double max_distance, RunContext& context) {
  const Stopwatch watch;
  const Starts starts = starts_of(solver, sources);
  const auto search = make_search(solver);
  const ShortestPathMap* map = nullptr;
  if (!starts.sources.empty())
    map = &run_search(solver, *search, starts.sources, {.radius = max_distance, .targets = targets.points()}, context);

  NearestResult result;
  result.csv = "target,distance,source,reach\n";
  for (std::size_t j = 0; j < targets.queries().size(); ++j) {
    const NamedPoint& target = targets.queries()[j];
    if (target.place.state == Place::State::dropped) {
      ++result.dropped;
      result.csv += target.label + ",nan,,dropped\n";
      continue;
    }
    Distance d = target.place.state == Place::State::isolated ? at_isolated(target.place, sources)
                 : map                                        ? at_surface(solver, *map, starts, sources, targets, j)
                                                              : Distance{};
    if (d.value > max_distance && d.reach == Reach::reached)
      d = {std::numeric_limits<double>::infinity(), Reach::beyond_limit, no_index};
    ++(d.reach == Reach::reached        ? result.reached
       : d.reach == Reach::beyond_limit ? result.beyond_limit
                                        : result.unreachable);
    result.csv += target.label + "," + number_text(d.value) + "," +
                  (d.source == no_index ? "" : sources[d.source].label) + "," + word(d.reach) + "\n";
  }
  result.seconds = watch.seconds();
  return result;
}

}  // namespace geodrome
