// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "plugins/common/mesh/packed_mesh.hpp"
#include "plugins/common/mesh/labels.hpp"
#include "plugins/common/requests/request_checks.hpp"
#include "plugins/common/requests/source_components.hpp"
#include "plugins/common/exact/watched_target.hpp"

namespace geodrome {

/// A search and its map: translates between the request, in the mesh's own numbers and units, and a propagation of
/// ways over the flat surface, in the numbers and units of that. A run costs what the propagation costs.
///
/// A `Propagation` is used again and again and has
/// - `Settings`, and a constructor `(const PackedMesh&, const Settings&)`; the surface outlives it;
/// - `void begin(bool keep, double limit)`: forgets the last run, even one that was stopped; nothing beyond the limit
///   is wanted; with `keep` it keeps what `way_to`, `trace` and `trace_from_vertex` need;
/// - `void seed(const Source&, Index number)`: the start distance is in the surface's units, the point has the mesh's
///   face number;
/// - `std::vector<Watched>& watched()`, const too: empty after `begin`, filled before `run` in ascending order of
///   faces, then lowered by ways that are found; their order stays;
/// - `void run(const RunContext&, lower_limit)`: goes on until nothing below the limit is left. Calls
///   `double lower_limit()`, a new limit if lower, once in `steps_a_poll` of its steps, so that looking at a target
///   costs about one step. May throw Cancelled;
/// - `labels()`, const: Labels of any step, with the distance of every vertex below the limit;
/// - `Way`, default constructible as none, with `double distance`, infinity if none, and `Index source`;
/// - `Way way_to(const SurfacePoint& inner, double best) const`: the shortest way through a kept window to a point that
///   is no vertex; none unless it is shorter than `best`;
/// - `void trace(const Way&, std::vector<SurfacePoint>& out) const`: appends the points of a way between the one it
///   leads to and its source, without both, with the mesh's face numbers;
/// - `void trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const`: the same from a vertex with a label,
///   which comes first; nothing if it is a source;
/// - `std::array<Counter, n> counters() const`: the last is "largest_search_bytes", the memory of the propagation.
/// VertexPropagation has `seed`, `watched`, `run` and `labels`.
template <class Propagation>
class PropagationSearch final : public Search, private ShortestPathMap {
 public:
  PropagationSearch(std::shared_ptr<const PackedMesh> surface, const typename Propagation::Settings& settings)
      : surface_(std::move(surface)),
        propagation_(*surface_, settings),
        distances_(surface_->vertex_count(), infinity) {
    count();
  }

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override;

 private:
  std::span<const double> vertices() const override { return distances_; }
  Distance at(const SurfacePoint& point) const override;
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override;
  std::span<const Counter> counters() const override { return counters_; }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  using Way = typename Propagation::Way;
  /// The shortest way to a point without windows: through a corner, or (none) straight from the source.
  struct PlainWay {
    double distance = infinity;
    Index source = no_index, corner = no_index;
  };

  /// The shortest of all, through `way` if that is one.
  struct NearestWay {
    double distance = infinity;
    Index source = no_index, corner = no_index;
    Way way;
  };

  const SurfaceMesh& mesh() const { return surface_->mesh(); }
  static auto face_then_place(const SurfacePoint& p) { return std::tie(p.face, p.b); }
  void seed(double units);
  void watch(const Request& request);
  double farthest_target(const Request& request) const;
  void finish(const Request& request);
  void count();
  PlainWay plain_way(const SurfacePoint& inner) const;
  PlainWay watched_way(const SurfacePoint& point) const;
  NearestWay nearest_way(const SurfacePoint& point) const;
  Distance judge(double distance, Index source, Index face) const;
  Distance distance_at(const SurfacePoint& point) const;

  std::shared_ptr<const PackedMesh> surface_;
  Propagation propagation_;
  std::vector<Source> sources_;
  std::vector<std::pair<SurfacePoint, Index>> sources_in_faces_;  // inner name, source; by face
  SourceComponents with_source_;
  double limit_ = 0;  // in the units of the flat surface
  double radius_ = 0;
  Keep keep_ = Keep::targets;
  KeptTargets kept_;
  std::vector<double> distances_;
  std::vector<Index> written_;
  decltype(std::declval<const Propagation&>().counters()) counters_{};
};

template <class Propagation>
const ShortestPathMap& PropagationSearch<Propagation>::run(std::span<const Source> sources, const Request& request,
                                                     RunContext& context) {
  require_valid(mesh(), sources, request);
  context.throw_if_cancelled();
  sources_.assign(sources.begin(), sources.end());
  keep_ = request.keep;
  radius_ = request.radius;
  with_source_.assign(mesh(), surface_->components(), sources_);
  const double units = std::ldexp(1.0, surface_->exponent());
  propagation_.begin(keep_ == Keep::map, radius_ * units);
  watch(request);
  seed(units);  // lines of a source that nearly lies on an edge cross the next face at once, and targets in it
  std::size_t polls = 0;  // looking at all targets must not cost more than the search
  propagation_.run(context, [&] {
    const bool look =
        request.stop_at_targets && ++polls % (1 + request.targets.size() / Propagation::steps_a_poll) == 0;
    return look ? farthest_target(request) : infinity;
  });
  finish(request);
  return *this;
}

template <class Propagation>
void PropagationSearch<Propagation>::seed(double units) {
  sources_in_faces_.clear();
  for (Index i = 0; i < sources_.size(); ++i) {
    propagation_.seed({sources_[i].at, sources_[i].start * units}, i);
    if (mesh().vertex_at(sources_[i].at) == no_index)
      surface_->for_each_name(surface_->inner(sources_[i].at),
                              [&](const SurfacePoint& name) { sources_in_faces_.emplace_back(name, i); });
  }
  std::stable_sort(sources_in_faces_.begin(), sources_in_faces_.end(),
                   [](const auto& a, const auto& b) { return a.first.face < b.first.face; });
}

/// Targets in faces are lowered while windows pass, unless the windows are kept and can be asked afterwards.
template <class Propagation>
void PropagationSearch<Propagation>::watch(const Request& request) {
  if (keep_ == Keep::map && !request.stop_at_targets) return;
  std::vector<Watched>& watched = propagation_.watched();
  for (const SurfacePoint& target : request.targets)
    if (mesh().vertex_at(target) == no_index)
      surface_->for_each_name(surface_->inner(target), [&](const SurfacePoint& name) { watched.push_back({name}); });
  std::sort(watched.begin(), watched.end(),
            [](const Watched& a, const Watched& b) { return face_then_place(a.at) < face_then_place(b.at); });
}

template <class Propagation>
double PropagationSearch<Propagation>::farthest_target(const Request& request) const {
  double farthest = 0;
  for (const SurfacePoint& target : request.targets) {
    const Index vertex = mesh().vertex_at(target);
    farthest =
        std::max(farthest, vertex == no_index ? watched_way(target).distance
                                              : propagation_.labels().distance(surface_->vertex_of_original(vertex)));
  }
  return farthest;
}

template <class Propagation>
void PropagationSearch<Propagation>::finish(const Request& request) {
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
    const PlainWay way = watched_way(target);
    return judge(way.distance, way.source, target.face);
  });
  count();
}

template <class Propagation>
void PropagationSearch<Propagation>::count() {
  counters_ = propagation_.counters();
  counters_.back().value += distances_.size() * (sizeof(double) + sizeof(Index));
}

template <class Propagation>
Distance PropagationSearch<Propagation>::at(const SurfacePoint& point) const {
  require_on_surface(mesh(), point, "the point");
  if (keep_ == Keep::map || mesh().vertex_at(point) != no_index) return distance_at(point);
  return kept_.at(point);
}

/// Of a vertex, or with all windows kept of any point.
template <class Propagation>
Distance PropagationSearch<Propagation>::distance_at(const SurfacePoint& point) const {
  const Index vertex = mesh().vertex_at(point);
  if (vertex != no_index) {
    const Label& label = propagation_.labels()[surface_->vertex_of_original(vertex)];
    return judge(label.distance, label.source, point.face);
  }
  const NearestWay nearest = nearest_way(point);
  return judge(nearest.distance, nearest.source, point.face);
}

/// To a point that is no vertex, with all windows kept. A point of an edge is asked for in each of its faces: in the
/// one that the way comes from, rounding where windows meet counts least.
template <class Propagation>
auto PropagationSearch<Propagation>::nearest_way(const SurfacePoint& point) const -> NearestWay {
  NearestWay nearest;
  surface_->for_each_name(surface_->inner(point), [&](const SurfacePoint& name) {
    const PlainWay plain = plain_way(name);
    if (plain.distance < nearest.distance) nearest = {plain.distance, plain.source, plain.corner, {}};
    const Way way = propagation_.way_to(name, nearest.distance);
    if (way.distance < nearest.distance) nearest = {way.distance, way.source, no_index, way};
  });
  return nearest;
}

/// To a target that was watched.
template <class Propagation>
auto PropagationSearch<Propagation>::watched_way(const SurfacePoint& point) const -> PlainWay {
  const auto& watched = propagation_.watched();
  PlainWay nearest;
  surface_->for_each_name(surface_->inner(point), [&](const SurfacePoint& name) {
    const auto found = std::lower_bound(
        watched.begin(), watched.end(), name,
        [](const Watched& w, const SurfacePoint& p) { return face_then_place(w.at) < face_then_place(p); });
    if (found->distance < nearest.distance) nearest = {found->distance, found->source};
    const PlainWay plain = plain_way(name);
    if (plain.distance < nearest.distance) nearest = plain;
  });
  return nearest;
}

/// A distance in the surface's units as an answer, for a point in a face of the mesh.
template <class Propagation>
Distance PropagationSearch<Propagation>::judge(double distance, Index source, Index face) const {
  const double value = std::ldexp(distance, -surface_->exponent());
  if (source != no_index && value <= radius_ && distance <= limit_) return {value, Reach::reached, source};
  const Index component = surface_->components()[mesh().triangles()[face][0]];
  return {infinity, with_source_.contains(component) ? Reach::beyond_limit : Reach::unreachable, no_index};
}

template <class Propagation>
auto PropagationSearch<Propagation>::plain_way(const SurfacePoint& inner) const -> PlainWay {
  PlainWay way;
  const Index frame = 3 * inner.face;
  const auto [x, y] = surface_->in_frame(frame, inner.b);
  auto it = std::lower_bound(sources_in_faces_.begin(), sources_in_faces_.end(), inner.face,
                             [](const auto& s, Index face) { return s.first.face < face; });
  for (; it != sources_in_faces_.end() && it->first.face == inner.face; ++it) {
    const auto [sx, sy] = surface_->in_frame(frame, it->first.b);
    const double start = std::ldexp(sources_[it->second].start, surface_->exponent());
    const double distance = start + surface_->weight(inner.face) * std::hypot(x - sx, y - sy);
    if (distance < way.distance) way = {distance, it->second};
  }
  for (Index i = 0; i < 3; ++i) {
    const Label& label = propagation_.labels()[surface_->from(frame + i)];
    if (label.source == no_index) continue;
    const auto [cx, cy] = surface_->in_frame(frame + i, inner.b);
    const double distance = label.distance + surface_->weight(inner.face) * std::hypot(cx, cy);
    if (distance < way.distance) way = {distance, label.source, surface_->from(frame + i)};
  }
  return way;
}

template <class Propagation>
void PropagationSearch<Propagation>::path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const {
  require_on_surface(mesh(), point, "the point");
  require_paths(keep_);
  out.clear();
  const Distance distance = distance_at(point);
  if (distance.reach != Reach::reached) return;
  const Index vertex = mesh().vertex_at(point);
  if (vertex != no_index) {
    propagation_.trace_from_vertex(surface_->vertex_of_original(vertex), out);
    if (out.empty())
      out.push_back(point);
    else
      out.front() = point;
    if (out.size() == 1 && mesh().vertex_at(sources_[distance.source].at) == vertex) return;
  } else {
    out.push_back(point);
    const NearestWay nearest = nearest_way(point);
    if (nearest.way.source != no_index)
      propagation_.trace(nearest.way, out);
    else if (nearest.corner != no_index)
      propagation_.trace_from_vertex(nearest.corner, out);
  }
  out.push_back(sources_[distance.source].at);
}

}  // namespace geodrome
