// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "geodrome/solver_kit/kept_search.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/propagation.hpp"
#include "plugins/common/exact/watched_target.hpp"
#include "plugins/common/mesh/for_listed_or_all.hpp"

namespace geodrome {

/// Makes a search of a propagation: translates between the request, in the mesh's own numbers and units, and the
/// propagation, in those of the packed mesh. Costs O(V) memory; a run costs what the propagation costs.
template <MeshPropagation Propagation>
class PropagationSearch final : public KeptSearch {
 public:
  PropagationSearch(std::shared_ptr<const PackedMesh> surface, const typename Propagation::Settings& settings)
      : KeptSearch(surface->mesh(), surface->components()),
        surface_(std::move(surface)),
        propagation_(*surface_, settings),
        distances_(surface_->vertex_count(), infinity) {
    count();
  }

  /// After a run: the limit up to which it is complete, in the units of the mesh. What is nearer was reached.
  double complete_up_to() const { return std::min(radius(), std::ldexp(limit_, -surface_->exponent())); }
  /// After a run: the propagation's.
  double factor() const requires KnowsLowerBounds<Propagation> { return propagation_.factor(); }
  /// After a run: for a vertex, and for every one, by the mesh's own numbers, a length that no path to it is below;
  /// +inf without any path. O(1) and O(V).
  double lower_bound(Index vertex) const requires KnowsLowerBounds<Propagation> {
    return lower_bound(vertex, std::ldexp(1.0, surface_->exponent()), complete_up_to());
  }
  void write_lower_bounds(std::span<double> bounds) const requires KnowsLowerBounds<Propagation>;

 private:
  std::span<const double> vertices() const override { return distances_; }
  std::span<const Counter> counters() const override { return counters_; }
  void search(const Request& request, RunContext& context) override;
  Distance distance_at(const SurfacePoint& point) const override;
  Distance target_distance(const SurfacePoint& target) const override;
  void trace(const SurfacePoint& point, const Distance& distance, std::vector<SurfacePoint>& out) const override;

  using Way = typename Propagation::Way;
  /// A path to a point without what tracing it takes. `plain_way` finds the shortest one that crosses no edge: from the
  /// vertex `corner` of the point's face, or, if that is no_index, straight from a source in the face. `watched_way`
  /// also returns one that a wavefront found, across any edges, with no_index for `corner`.
  struct PlainWay {
    double distance = infinity;
    Index source = no_index, corner = no_index;
  };

  /// The shortest path of all: `way` if that is one, else from a corner or a source of the face.
  struct NearestWay {
    double distance = infinity;
    Index source = no_index, corner = no_index;
    Way way;
  };

  static auto face_then_place(const SurfacePoint& p) { return std::tie(p.face, p.b); }
  void seed(double units);
  void watch(const Request& request);
  double farthest_target(const Request& request) const;
  void write_distances();
  double lower_bound(Index vertex, double units, double complete) const requires KnowsLowerBounds<Propagation>;
  void count();
  PlainWay plain_way(const SurfacePoint& inner) const;
  PlainWay watched_way(const SurfacePoint& point) const;
  NearestWay nearest_way(const SurfacePoint& point) const;
  Distance judge(double distance, Index source, Index face) const;

  std::shared_ptr<const PackedMesh> surface_;
  Propagation propagation_;
  std::vector<std::pair<SurfacePoint, Index>> sources_in_faces_;  // inner name, source; by face
  double limit_ = 0;                                              // in the units of the packed mesh
  std::vector<double> distances_;
  std::vector<Index> written_;
  decltype(std::declval<const Propagation&>().counters()) counters_{};
};

template <MeshPropagation Propagation>
void PropagationSearch<Propagation>::search(const Request& request, RunContext& context) {
  const double units = std::ldexp(1.0, surface_->exponent());
  propagation_.begin(keep() == Keep::map, radius() * units);
  watch(request);
  seed(units);  // lines of a source that nearly lies on an edge cross the next face at once, and targets in it
  std::size_t polls = 0;  // looking at all targets must not cost more than the search
  propagation_.run(context, [&] {
    const bool look =
        request.stop_at_targets && ++polls % (1 + request.targets.size() / Propagation::steps_a_poll) == 0;
    return look ? farthest_target(request) : infinity;
  });
  limit_ = request.stop_at_targets ? farthest_target(request) : infinity;
  write_distances();
  count();
}

template <MeshPropagation Propagation>
void PropagationSearch<Propagation>::seed(double units) {
  sources_in_faces_.clear();
  for (Index i = 0; i < sources().size(); ++i) {
    propagation_.seed({sources()[i].at, sources()[i].start * units}, i);
    if (mesh().vertex_at(sources()[i].at) == no_index)
      surface_->for_each_name(surface_->inner(sources()[i].at),
                              [&](const SurfacePoint& name) { sources_in_faces_.emplace_back(name, i); });
  }
  std::stable_sort(sources_in_faces_.begin(), sources_in_faces_.end(),
                   [](const auto& a, const auto& b) { return a.first.face < b.first.face; });
}

/// Targets in faces are lowered while wavefronts pass, unless everything is kept and can be asked afterwards.
template <MeshPropagation Propagation>
void PropagationSearch<Propagation>::watch(const Request& request) {
  if (keep() == Keep::map && !request.stop_at_targets) return;
  std::vector<Watched>& watched = propagation_.watched();
  for (const SurfacePoint& target : request.targets)
    if (mesh().vertex_at(target) == no_index)
      surface_->for_each_name(surface_->inner(target), [&](const SurfacePoint& name) { watched.push_back({name}); });
  std::sort(watched.begin(), watched.end(),
            [](const Watched& a, const Watched& b) { return face_then_place(a.at) < face_then_place(b.at); });
}

template <MeshPropagation Propagation>
double PropagationSearch<Propagation>::farthest_target(const Request& request) const {
  double farthest = 0;
  for (const SurfacePoint& target : request.targets) {
    const Index vertex = mesh().vertex_at(target);
    farthest =
        std::max(farthest, vertex == no_index ? watched_way(target).distance
                                              : propagation_.answer(surface_->vertex_of_original(vertex)).distance);
  }
  return farthest;
}

template <MeshPropagation Propagation>
void PropagationSearch<Propagation>::write_distances() {
  const double units = std::ldexp(1.0, surface_->exponent());
  for_listed_or_all(written_, distances_.size(), [&](Index v) { distances_[v] = infinity; });
  written_.clear();
  for_listed_or_all(propagation_.reached(), distances_.size(), [&](Index v) {
    const double inner = propagation_.answer(v).distance, value = inner / units;
    if (inner == infinity || value > radius() || inner > limit_) return;
    written_.push_back(surface_->original_vertex(v));
    distances_[written_.back()] = value;
  });
}

/// What was found may be longer than what waits beyond the limit, and by rounding than the answer.
template <MeshPropagation Propagation>
double PropagationSearch<Propagation>::lower_bound(Index vertex, double units,
                                                   double complete) const requires KnowsLowerBounds<Propagation> {
  if (!shares_component_with_source(vertex)) return infinity;
  const double found = propagation_.lower_bound(surface_->vertex_of_original(vertex)) / units;
  return std::min({found, complete, distances_[vertex]});
}

template <MeshPropagation Propagation>
void PropagationSearch<Propagation>::write_lower_bounds(std::span<double> bounds) const requires
    KnowsLowerBounds<Propagation> {
  const double units = std::ldexp(1.0, surface_->exponent()), complete = complete_up_to();
  for (Index v = 0; v < bounds.size(); ++v) bounds[v] = lower_bound(v, units, complete);
}

template <MeshPropagation Propagation>
void PropagationSearch<Propagation>::count() {
  counters_ = propagation_.counters();
  counters_.back().value += distances_.size() * (sizeof(double) + sizeof(Index));
}

template <MeshPropagation Propagation>
Distance PropagationSearch<Propagation>::distance_at(const SurfacePoint& point) const {
  const Index vertex = mesh().vertex_at(point);
  if (vertex != no_index) {
    const FoundDistance found = propagation_.answer(surface_->vertex_of_original(vertex));
    return judge(found.distance, found.source, point.face);
  }
  const NearestWay nearest = nearest_way(point);
  return judge(nearest.distance, nearest.source, point.face);
}

template <MeshPropagation Propagation>
Distance PropagationSearch<Propagation>::target_distance(const SurfacePoint& target) const {
  if (mesh().vertex_at(target) != no_index) return distance_at(target);
  const PlainWay way = watched_way(target);
  return judge(way.distance, way.source, target.face);
}

/// Returns the shortest path to a point that is no vertex, if everything was kept. A point of an edge is looked up in
/// each of its faces: in the face that the path comes from, rounding where windows meet counts least.
template <MeshPropagation Propagation>
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

/// Returns the shortest path to a target that was watched during the run.
template <MeshPropagation Propagation>
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

/// Turns a distance in the packed mesh's units into an answer for a point in a face of the mesh.
template <MeshPropagation Propagation>
Distance PropagationSearch<Propagation>::judge(double distance, Index source, Index face) const {
  const double value = std::ldexp(distance, -surface_->exponent());
  if (source != no_index && value <= radius() && distance <= limit_) return {value, Reach::reached, source};
  return no_distance(face);
}

template <MeshPropagation Propagation>
auto PropagationSearch<Propagation>::plain_way(const SurfacePoint& inner) const -> PlainWay {
  PlainWay way;
  const Index frame = 3 * inner.face;
  const auto [x, y] = surface_->in_frame(frame, inner.b);
  auto it = std::lower_bound(sources_in_faces_.begin(), sources_in_faces_.end(), inner.face,
                             [](const auto& s, Index face) { return s.first.face < face; });
  for (; it != sources_in_faces_.end() && it->first.face == inner.face; ++it) {
    const auto [sx, sy] = surface_->in_frame(frame, it->first.b);
    const double start = std::ldexp(sources()[it->second].start, surface_->exponent());
    const double distance = start + surface_->weight(inner.face) * std::hypot(x - sx, y - sy);
    if (distance < way.distance) way = {distance, it->second};
  }
  for (Index i = 0; i < 3; ++i) {
    const FoundDistance corner = propagation_.answer(surface_->from(frame + i));
    if (corner.source == no_index) continue;
    const auto [cx, cy] = surface_->in_frame(frame + i, inner.b);
    const double distance = corner.distance + surface_->weight(inner.face) * std::hypot(cx, cy);
    if (distance < way.distance) way = {distance, corner.source, surface_->from(frame + i)};
  }
  return way;
}

template <MeshPropagation Propagation>
void PropagationSearch<Propagation>::trace(const SurfacePoint& point, const Distance& distance,
                                           std::vector<SurfacePoint>& out) const {
  const SurfacePoint& source = sources()[distance.source].at;
  const Index vertex = mesh().vertex_at(point);
  if (vertex != no_index) {
    propagation_.trace_from_vertex(surface_->vertex_of_original(vertex), out);
    if (out.empty())
      out.push_back(point);
    else
      out.front() = point;
    if (out.size() == 1 && mesh().vertex_at(source) == vertex) return;
  } else {
    out.push_back(point);
    const NearestWay nearest = nearest_way(point);
    if (nearest.way.source != no_index)
      propagation_.trace(nearest.way, out);
    else if (nearest.corner != no_index)
      propagation_.trace_from_vertex(nearest.corner, out);
  }
  out.push_back(source);
}

}  // namespace geodrome
