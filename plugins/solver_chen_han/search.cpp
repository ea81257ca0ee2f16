// SPDX-License-Identifier: MIT
#include "solver_chen_han/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver_chen_han/path_tracer.hpp"

namespace geodrome::chen_han {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The propagation asks for a limit once in so many of its steps, so that a target costs about one step.
constexpr std::size_t steps_a_poll = 256;

}  // namespace

WindowSearch::WindowSearch(std::shared_ptr<const FlatSurface> surface, const Settings& settings)
    : surface_(std::move(surface)), propagation_(*surface_, settings), distances_(surface_->vertex_count(), infinity) {
  count();
}

const ShortestPathMap& WindowSearch::run(std::span<const Source> sources, const Request& request, RunContext& context) {
  require_valid(mesh(), sources, request);
  context.throw_if_cancelled();
  sources_.assign(sources.begin(), sources.end());
  keep_ = request.keep;
  radius_ = request.radius;
  with_source_.assign(mesh(), surface_->components(), sources_);
  const double units = std::ldexp(1.0, surface_->exponent());
  propagation_.begin(keep_ == Keep::map, radius_ * units);
  sources_in_faces_.clear();
  for (Index i = 0; i < sources_.size(); ++i) {
    propagation_.seed({sources_[i].at, sources_[i].start * units}, i);
    if (mesh().vertex_at(sources_[i].at) == no_index)
      surface_->for_each_name(surface_->inner(sources_[i].at),
                              [&](const SurfacePoint& name) { sources_in_faces_.emplace_back(name, i); });
  }
  std::stable_sort(sources_in_faces_.begin(), sources_in_faces_.end(),
                   [](const auto& a, const auto& b) { return a.first.face < b.first.face; });
  watch(request);
  std::size_t polls = 0;  // looking at all targets must not cost more than the search
  propagation_.run(context, [&] {
    const bool look = request.stop_at_targets && ++polls % (1 + request.targets.size() / steps_a_poll) == 0;
    return look ? farthest_target(request) : infinity;
  });
  finish(request);
  return *this;
}

/// Targets in faces are lowered while windows pass, unless the windows are kept and can be asked afterwards.
void WindowSearch::watch(const Request& request) {
  if (keep_ == Keep::map && !request.stop_at_targets) return;
  std::vector<Watched>& watched = propagation_.watched();
  for (const SurfacePoint& target : request.targets) {
    if (mesh().vertex_at(target) != no_index) continue;
    watched.push_back({surface_->inner(target), infinity, no_index});
  }
  std::sort(watched.begin(), watched.end(), [](const Watched& a, const Watched& b) {
    return std::tie(a.at.face, a.at.b) < std::tie(b.at.face, b.at.b);
  });
}

double WindowSearch::farthest_target(const Request& request) const {
  double farthest = 0;
  for (const SurfacePoint& target : request.targets) {
    const Index vertex = mesh().vertex_at(target);
    if (vertex != no_index)
      farthest = std::max(farthest, propagation_.labels().distance(surface_->vertex_of_original(vertex)));
  }
  for (const Watched& w : propagation_.watched())
    farthest = std::max(farthest, std::min(w.distance, plain_way(w.at).distance));
  return farthest;
}

void WindowSearch::finish(const Request& request) {
  const double units = std::ldexp(1.0, surface_->exponent());
  limit_ = request.stop_at_targets ? farthest_target(request) : infinity;
  for (const Index v : written_) distances_[v] = infinity;
  written_.clear();
  for (const Index v : propagation_.labels().touched()) {
    const double inner = propagation_.labels().distance(v), value = inner / units;
    if (value > radius_ || inner > limit_) continue;
    written_.push_back(surface_->original_vertex(v));
    distances_[written_.back()] = value;
  }
  kept_.assign(request.targets, [this](const SurfacePoint& target) {
    if (keep_ == Keep::map || mesh().vertex_at(target) != no_index) return distance_at(target);
    const SurfacePoint inner = surface_->inner(target);
    const auto& watched = propagation_.watched();
    const auto found = std::lower_bound(watched.begin(), watched.end(), inner, [](const Watched& w, const auto& p) {
      return std::tie(w.at.face, w.at.b) < std::tie(p.face, p.b);
    });
    const Way plain = plain_way(inner);
    const bool through_window = found->distance < plain.distance;
    return judge(through_window ? found->distance : plain.distance, through_window ? found->source : plain.source,
                 target.face);
  });
  count();
}

void WindowSearch::count() {
  const Counts& c = propagation_.counts();
  counters_ = {{{"windows_created", c.created},
                {"windows_propagated", c.propagated},
                {"windows_filtered", c.filtered},
                {"windows_trimmed", c.trimmed},
                {"half_edges_passed", c.passes},
                {"vertices_emitted", c.emissions},
                {"largest_window_list", c.longest},
                {"largest_search_bytes", propagation_.bytes() + distances_.size() * (sizeof(double) + sizeof(Index))}}};
}

Distance WindowSearch::at(const SurfacePoint& point) const {
  require_on_surface(mesh(), point, "the point");
  if (keep_ == Keep::map || mesh().vertex_at(point) != no_index) return distance_at(point);
  return kept_.at(point);
}

Distance WindowSearch::distance_at(const SurfacePoint& point) const {
  const Index vertex = mesh().vertex_at(point);
  if (vertex != no_index) {
    const Label& label = propagation_.labels()[surface_->vertex_of_original(vertex)];
    return judge(label.distance, label.source, point.face);
  }
  const Way way = way_to(point);
  return judge(way.distance, way.source, point.face);
}

Distance WindowSearch::judge(double distance, Index source, Index face) const {
  const double value = std::ldexp(distance, -surface_->exponent());
  if (source != no_index && value <= radius_ && distance <= limit_) return {value, Reach::reached, source};
  const Index component = surface_->components()[mesh().triangles()[face][0]];
  return {infinity, with_source_.contains(component) ? Reach::beyond_limit : Reach::unreachable, no_index};
}

/// Without windows: straight from a source in the same face, or through a corner.
WindowSearch::Way WindowSearch::plain_way(const SurfacePoint& inner) const {
  Way way{infinity};
  const Index frame = 3 * inner.face;
  const auto [x, y] = surface_->in_frame(frame, inner.b);
  auto it = std::lower_bound(sources_in_faces_.begin(), sources_in_faces_.end(), inner.face,
                             [](const auto& s, Index face) { return s.first.face < face; });
  for (; it != sources_in_faces_.end() && it->first.face == inner.face; ++it) {
    const auto [sx, sy] = surface_->in_frame(frame, it->first.b);
    const double start = std::ldexp(sources_[it->second].start, surface_->exponent());
    const double distance = start + std::hypot(x - sx, y - sy);
    if (distance < way.distance) way = {distance, x, y, it->second};
  }
  for (Index i = 0; i < 3; ++i) {
    const Label& label = propagation_.labels()[surface_->from(frame + i)];
    if (label.source == no_index) continue;
    const auto [cx, cy] = surface_->in_frame(frame + i, inner.b);
    const double distance = label.distance + std::hypot(cx, cy);
    if (distance < way.distance) way = {distance, cx, cy, label.source, surface_->from(frame + i)};
  }
  return way;
}

WindowSearch::Way WindowSearch::way_to(const SurfacePoint& point) const {
  const SurfacePoint inner = surface_->inner(point);
  Way way = plain_way(inner);
  for (Index h = 3 * inner.face; h < 3 * inner.face + 3; ++h) {
    const auto [x, y] = surface_->in_frame(h, inner.b);
    propagation_.kept().for_each(h, [&, x = x, y = y](Index number, const Window& window) {
      const double distance = way_through(window, x, y, way.distance);
      if (distance < way.distance) way = {distance, x, y, propagation_.source_of(window.origin), no_index, number};
    });
  }
  return way;
}

void WindowSearch::path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const {
  require_on_surface(mesh(), point, "the point");
  require_paths(keep_);
  out.clear();
  const Distance distance = distance_at(point);
  if (distance.reach != Reach::reached) return;
  PathTracer tracer(*surface_, propagation_.labels(), propagation_.kept(), out);
  const Index vertex = mesh().vertex_at(point);
  if (vertex != no_index) {
    tracer.from_vertex(surface_->vertex_of_original(vertex));
    if (out.empty())
      out.push_back(point);
    else
      out.front() = point;
    if (out.size() == 1 && mesh().vertex_at(sources_[distance.source].at) == vertex) return;
  } else {
    out.push_back(point);
    const Way way = way_to(point);
    if (way.window != no_index)
      tracer.from_point(way.window, way.x, way.y);
    else if (way.corner != no_index)
      tracer.from_vertex(way.corner);
  }
  out.push_back(sources_[distance.source].at);
}

}  // namespace geodrome::chen_han
