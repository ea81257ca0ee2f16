// SPDX-License-Identifier: MIT
#include "engine/search/distance_row.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/remedies.hpp"

namespace geodrome {

namespace {

constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();

bool is_no_vertex(const NamedPoint& query) {
  return query.place.state == Place::State::on_surface && query.place.vertex == no_index;
}

/// The distance from a source that no search can start from, or whose start distance is beyond the limit already.
double without_search(const NamedPoint& source, const Place& target, double radius) {
  if (source.place.state == Place::State::dropped || target.state == Place::State::dropped) return not_computed;
  const bool same = target.state == Place::State::isolated && target.vertex == source.place.vertex;
  return same && radius >= 0 ? source.start : infinity;
}

}  // namespace

const ShortestPathMap& run_search(const PreparedSolver& solver, Search& search, std::span<const Source> sources,
                                  const Request& request, RunContext& context) {
  return cross_boundary(solver.plugin.info,
                        [&]() -> const ShortestPathMap& { return search.run(sources, request, context); });
}

std::unique_ptr<Search> make_search(const PreparedSolver& solver) {
  return cross_boundary(solver.plugin.info, [&] { return solver.prepared->make_search(); });
}

void demand(const PreparedSolver& solver, Provides wanted, const char* what) {
  if (!solver.provides(wanted))
    throw CapabilityError(solver.plugin.info.full_name() + " does not provide " + what,
                          remedies::solver_that_provides());
}

void check_provides(const PreparedSolver& solver, std::span<const NamedPoint> sources,
                    std::span<const NamedPoint> targets, double max_distance) {
  if (std::any_of(sources.begin(), sources.end(), is_no_vertex))
    demand(solver, Provides::face_sources, "sources that are no vertices (face_sources)");
  if (std::any_of(targets.begin(), targets.end(), is_no_vertex))
    demand(solver, Provides::any_point, "distances of points inside faces (any_point)");
  if (std::isfinite(max_distance)) demand(solver, Provides::radius_limit, "a largest distance (radius_limit)");
}

TargetList::TargetList(std::vector<NamedPoint> queries, const PlacedSurface& surface)
    : queries_(std::move(queries)), estimated_(surface.made_from == InputKind::points) {
  for (const NamedPoint& query : queries_) {
    first_.push_back(points_.size());
    if (is_no_vertex(query)) points_.push_back(query.place.at);
  }
  first_.push_back(points_.size());
}

TargetList::TargetList(std::vector<NamedPoint> queries, const std::vector<std::vector<SurfacePoint>>& points)
    : queries_(std::move(queries)), estimated_(false) {
  for (const auto& of_target : points) {
    first_.push_back(points_.size());
    points_.insert(points_.end(), of_target.begin(), of_target.end());
  }
  first_.push_back(points_.size());
}

double TargetList::read(const ShortestPathMap& map, std::size_t j) const {
  const Place& place = queries_[j].place;
  if (place.state == Place::State::dropped) return not_computed;
  if (place.state == Place::State::isolated) return infinity;
  const auto checked = [&](double value) {
    if (value >= 0) return value;
    throw NumericalError("computed " + std::to_string(value) + " as the distance of target " + queries_[j].label,
                         "choose another solver, and report this to the author of the plugin");
  };
  if (place.vertex != no_index) return checked(map.vertices()[place.vertex]);
  double least = infinity;
  for (std::size_t k = first_[j]; k < first_[j + 1]; ++k) least = std::min(least, checked(map.at(points_[k]).value));
  return least;
}

double TargetList::lower_bound(const NamedPoint& source, std::size_t j) const {
  return estimated_ ? distance(source.place.position, queries_[j].place.position) : 0;
}

std::span<const Counter> distance_row(const PreparedSolver& solver, Search& search, const NamedPoint& source,
                                      const TargetList& targets, double max_distance, RunContext& context,
                                      std::span<double> row) {
  // With a single source its start distance only shifts the row, so no solver needs to know of it.
  const double radius = max_distance - source.start;
  if (source.place.state != Place::State::on_surface || radius < 0) {
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = without_search(source, targets.queries()[j].place, radius);
    return {};
  }
  const Source from{source.place.at, 0};
  const ShortestPathMap& map =
      run_search(solver, search, {&from, 1}, {.radius = radius, .targets = targets.points()}, context);
  return cross_boundary(solver.plugin.info, [&] {
    for (std::size_t j = 0; j < row.size(); ++j) {
      double d = targets.read(map, j);
      if (!std::isnan(d)) d = std::max(d, targets.lower_bound(source, j));
      row[j] = d > radius ? infinity : d + source.start;
    }
    return map.counters();
  });
}

}  // namespace geodrome
