// SPDX-License-Identifier: MIT
#include "engine/search/smooth_distances.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/search/nearest_sources.hpp"
#include "engine/smooth/fronts/march.hpp"
#include "engine/smooth/fronts/path_end.hpp"

namespace geodrome {

namespace {

/// Nodes that are asked for at once: many, so that what a call costs does not count, and few enough for a cache.
constexpr std::size_t nodes_at_once = 2048;

void check(const SmoothLength& path, const NamedPoint& target) {
  if (!(path.length >= 0 && path.length < infinity) || !is_distance(path.error.value()))
    throw NumericalError("gave a smooth surface on which the path to target " + target.label + " is " +
                             number_text(path.length) + " long",
                         "choose another tangent estimator, and report this to the author of the plugin");
}

/// Shortens the paths of a map to many targets, some at a time.
template <class Use>
class ManyPaths {
 public:
  /// `use(j, path)` is told what became of the path to target j.
  ManyPaths(const PreparedSolver& solver, const TargetList& targets, Use use)
      : solver_(solver), targets_(targets), use_(use), shortening_(solver.smooth->charts) {}

  void add(const ShortestPathMap& map, std::size_t target) {
    cross_boundary(solver_.plugin.info, [&] {
      map.path(targets_.named()[target].place.at, path_);
      if (path_.empty())
        throw NumericalError(
            "gave no path to target " + targets_.named()[target].label + ", which it has a distance of",
            "choose another solver, and report this to the author of the plugin");
      shortening_.add(path_);
    });
    waiting_.push_back(target);
    if (shortening_.nodes() >= nodes_at_once) finish();
  }

  void finish() {
    cross_boundary(solver_.smooth->plugin, [&] {
      const std::span<const SmoothLength> lengths = shortening_.run();
      for (std::size_t k = 0; k < waiting_.size(); ++k) {
        check(lengths[k], targets_.named()[waiting_[k]]);
        use_(waiting_[k], lengths[k]);
      }
    });
    waiting_.clear();
  }

 private:
  const PreparedSolver& solver_;
  const TargetList& targets_;
  Use use_;
  Shortening shortening_;
  std::vector<SurfacePoint> path_;
  std::vector<std::size_t> waiting_;
};

void note_change(SmoothFigures& figures, double before, double after) {
  if (std::isfinite(after)) figures.largest_change = std::max(figures.largest_change, std::abs(after - before));
}

/// Replaces the distances on the triangles. Without a map there are none but those of points to themselves.
SmoothFigures smooth_nearest(const PreparedSolver& solver, const ShortestPathMap* map,
                             std::span<const NamedPoint> sources, const TargetList& targets, double max_distance,
                             std::span<Distance> nearest) {
  SmoothFigures figures;
  const DistanceRule rule{targets.bounded(), max_distance};
  ManyPaths paths(solver, targets, [&](std::size_t j, const SmoothLength& path) {
    figures.add(path);
    const double flat = nearest[j].value;
    const NamedPoint& source = sources[nearest[j].source];
    const double d = rule(path.length + source.start, source, targets.named()[j]);
    nearest[j].value = d;
    if (std::isinf(d)) nearest[j].reach = Reach::beyond_limit, nearest[j].source = no_index;
    note_change(figures, flat, d);
  });
  for (std::size_t j = 0; map && j < nearest.size(); ++j)
    if (nearest[j].reach == Reach::reached && targets.named()[j].place.state == Place::State::on_surface)
      paths.add(*map, j);
  paths.finish();
  return figures;
}

bool is_measured(const TargetList& targets, std::span<const double> row, std::size_t j) {
  return std::isfinite(row[j]) && targets.named()[j].place.state == Place::State::on_surface;
}

/// Shortens the path to each target by itself.
SmoothFigures traced_row(const PreparedSolver& solver, const ShortestPathMap& map, const NamedPoint& source,
                         const TargetList& targets, double max_distance, std::span<double> row) {
  SmoothFigures figures;
  const DistanceRule rule{targets.bounded(), max_distance};
  ManyPaths paths(solver, targets, [&](std::size_t j, const SmoothLength& path) {
    figures.add(path);
    const double flat = row[j];
    row[j] = rule(path.length + source.start, source, targets.named()[j]);
    note_change(figures, flat, row[j]);
  });
  for (std::size_t j = 0; j < row.size(); ++j)
    if (is_measured(targets, row, j)) paths.add(map, j);
  paths.finish();
  return figures;
}

/// Measures on the smooth surface what the march is asked for.
class ShortenedPaths {
 public:
  ShortenedPaths(const PreparedSolver& solver, const ShortestPathMap& map)
      : solver_(solver), map_(map), shortening_(solver.smooth->charts) {}

  FrontPoint find(const SurfacePoint& at) {
    cross_boundary(solver_.plugin.info, [&] {
      map_.path(at, path_);
      if (!path_.empty()) shortening_.add(path_);
    });
    if (path_.empty()) return {};  // beyond the radius
    const EdgeCurves& curves = *solver_.smooth->curves;
    return cross_boundary(solver_.smooth->plugin, [&] {
      shortening_.run();
      return front_at_end(curves, shortening_, 0, curves.mesh().vertex_at(at));
    });
  }

 private:
  const PreparedSolver& solver_;
  const ShortestPathMap& map_;
  Shortening shortening_;
  std::vector<SurfacePoint> path_;
};

/// Carries the distances from the source to the vertices, and from there to the targets.
SmoothFigures marched_row(const PreparedSolver& solver, const ShortestPathMap& map, const NamedPoint& source,
                          const TargetList& targets, double max_distance, std::span<double> row, Reading reading) {
  SmoothFigures figures;
  const DistanceRule rule{targets.bounded(), max_distance};
  ShortenedPaths paths(solver, map);
  FrontMarch march(*solver.smooth->curves);
  march.run(map.vertices(), source.place.at, [&](const SurfacePoint& at) { return paths.find(at); });
  const auto take = [&](std::size_t j, const FrontPoint& found, bool is_read) {
    const double flat = row[j];
    const double along = is_read ? flat - source.start : found.distance;
    SmoothLength length{.length = found.distance,
                        .flat = along,
                        .smooth = std::max(0.0, along - found.flat),
                        .error = found.error,
                        .moved = found.moved};
    length.error.add_carried(found.carried);
    if (is_read || found.known()) cross_boundary(solver.smooth->plugin, [&] { check(length, targets.named()[j]); });
    row[j] = rule(found.distance + source.start, source, targets.named()[j]);
    if (!found.known()) return;
    if (!is_read) return figures.add_alone(length);
    figures.add(length);
    note_change(figures, flat, row[j]);
  };
  for (std::size_t j = 0; j < row.size(); ++j)
    if (const Place& place = targets.named()[j].place; place.vertex != no_index && is_measured(targets, row, j))
      take(j, march.at_vertex(place.vertex), true);
  for (const std::size_t j : targets.by_face())
    if (is_measured(targets, row, j))
      take(j, march.at(targets.named()[j].place.at, targets.above(j)), reading == Reading::all);
  return figures;
}

}  // namespace

void SmoothFigures::add(const SmoothLength& path) {
  if (!(path.flat > 0)) return;
  const double change = std::abs(path.length / path.flat - 1);
  ++compared, correction += change, largest_correction = std::max(largest_correction, change);
  add_alone(path);
}

void SmoothFigures::add_alone(const SmoothLength& path) {
  if (!(path.flat > 0)) return;
  const double off = path.error.value();
  ++paths, left += !path.moved;
  flat += path.flat, smooth += path.smooth;
  error += off, largest_error = std::max(largest_error, off / path.flat);
}

void SmoothFigures::add(const SmoothFigures& other) {
  paths += other.paths, left += other.left, compared += other.compared;
  flat += other.flat, smooth += other.smooth;
  correction += other.correction, largest_correction = std::max(largest_correction, other.largest_correction);
  error += other.error, largest_error = std::max(largest_error, other.largest_error);
  largest_change = std::max(largest_change, other.largest_change);
}

double searched_radius(const PreparedSolver& solver, double max_distance) {
  return solver.smooth ? farther_for_smooth * max_distance + solver.smooth->around : max_distance;
}

SmoothFigures smooth_row(const PreparedSolver& solver, const ShortestPathMap& map, const NamedPoint& source,
                         const TargetList& targets, double max_distance, std::span<double> row, Reading reading) {
  return solver.smooth->curves ? marched_row(solver, map, source, targets, max_distance, row, reading)
                               : traced_row(solver, map, source, targets, max_distance, row);
}

MeasuredNearest measured_nearest(const PreparedSolver& solver, std::span<const NamedPoint> sources,
                                 const TargetList& targets, double max_distance, RunContext& context,
                                 const WatchNearest& watch) {
  MeasuredNearest result{.radius = max_distance};
  if (!solver.smooth) {
    result.distances = nearest_distances(solver, sources, targets, max_distance, context, watch);
    return result;
  }
  result.radius *= farther_for_smooth;
  const auto watch_map = [&](const ShortestPathMap* map, std::span<const Distance> nearest) {
    if (watch) watch(map, nearest);
    result.distances.assign(nearest.begin(), nearest.end());
    result.smooth = smooth_nearest(solver, map, sources, targets, max_distance, result.distances);
  };
  result.flat = nearest_distances(solver, sources, targets, result.radius, context, watch_map, Keep::map);
  compare_sources(solver, sources, targets, max_distance, context, result);
  return result;
}

void smooth_path(const PreparedSolver& solver, const NamedPoint& from, const TargetList& to, PathResult& path) {
  if (path.points.empty()) return;
  Shortening shortening(solver.smooth->charts);
  cross_boundary(solver.plugin.info, [&] { shortening.add(path.points); });
  cross_boundary(solver.smooth->plugin, [&] {
    const SmoothLength found = shortening.run()[0];
    check(found, to.named()[0]);
    path.length = found.length;
    if (!(found.flat > 0)) return;  // one point, as it was
    path.points.clear(), path.positions.clear();
    shortening.curve(0, path.points, path.positions);
  });
  path.distance = DistanceRule{to.bounded()}(path.length, {from.place}, to.named()[0]);
}

}  // namespace geodrome
