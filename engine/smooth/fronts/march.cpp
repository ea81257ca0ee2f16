// SPDX-License-Identifier: MIT
#include "engine/smooth/fronts/march.hpp"

#include <algorithm>
#include <utility>

namespace geodrome {

namespace {

/// What a vertex learns where ways meet may tell its neighbours of a way that they did not know.
constexpr int passes_where_ways_meet = 2;

/// Where steps are estimated to have changed more of a distance, a path of its own is worth its cost.
constexpr double most_carried = 1e-5;

}  // namespace

void FrontMarch::run(std::span<const double> flat, const SurfacePoint& source, Shortened shortened) {
  shortened_ = std::move(shortened), source_ = source;
  field_.clear(), order_.clear(), met_.clear();
  is_met_.assign(flat.size(), false);
  find_source();
  for (Index v = 0; v < flat.size(); ++v)
    if (flat[v] < infinity) order_.push_back(v);
  std::ranges::sort(order_, {}, [&](Index v) { return std::pair(flat[v], v); });
  for (const Index v : order_) reach(v);
  for (int pass = 0; pass < passes_where_ways_meet; ++pass)
    for (const Index v : met_) reconsider(v);
}

/// Notes the corners of all faces that hold the source: paths to them come over no edge.
void FrontMarch::find_source() {
  const EdgeCurves& curves = field_.curves();
  at_source_.clear();
  for (const Index v : curves.mesh().triangles()[source_.face])
    for (const Index h : curves.starting_at(v))
      if (curves.charts().on_face(source_, h / 3))
        for (const Index corner : curves.mesh().triangles()[h / 3]) at_source_.push_back(corner);
  std::ranges::sort(at_source_);
}

bool FrontMarch::is_at_source(Index v) const { return std::ranges::binary_search(at_source_, v); }

FrontPoint FrontMarch::along_path(const SurfacePoint& at) {
  ++paths_;
  return shortened_(at);
}

/// Asks all neighbours of a vertex that are known. Returns false if there is none, or one that fronts do not go on
/// from.
bool FrontMarch::forecast_at(Index v) {
  forecasts_.clear();
  const EdgeCurves& curves = field_.curves();
  const SurfaceMesh& mesh = curves.mesh();
  const VertexShape& shape = curves.vertex(v);
  bool all = true;
  const auto ask = [&](Index from) {
    if (field_[from].goes_on())
      forecasts_.push_back(field_.forecast(from, shape.position, shape.normal));
    else
      all &= !field_[from].known() || is_at_source(from);
  };
  for (const Index h : curves.starting_at(v)) {
    ask(mesh.to(h));
    const Index last = SurfaceMesh::previous(h);
    if (mesh.twins()[last] == no_index) ask(mesh.from(last));
  }
  return all && !forecasts_.empty();
}

bool FrontMarch::agree() const {
  return std::ranges::all_of(forecasts_, [&](const Forecast& one) { return one.same_way(forecasts_[0]); });
}

void FrontMarch::note_meeting(Index v) {
  if (is_met_[v]) return;
  is_met_[v] = true;
  met_.push_back(v);
}

void FrontMarch::reach(Index v) {
  const EdgeCurves& curves = field_.curves();
  FrontPoint found;
  const bool all = !is_at_source(v) && forecast_at(v);
  if (all) {
    const auto nearest = std::ranges::min_element(forecasts_, {}, &Forecast::squared);
    found = field_.arrive(field_.target(v), -nearest->half);
    if (!agree()) {
      note_meeting(v);
      for (const Index h : curves.starting_at(v))
        if (field_[curves.mesh().to(h)].known()) note_meeting(curves.mesh().to(h));
    }
  }
  if (!found.known() || found.carried > most_carried * found.distance) found = along_path(curves.mesh().at_vertex(v));
  field_.set(v, found);
}

/// Looks for a nearer way to a vertex where ways meet.
void FrontMarch::reconsider(Index v) {
  if (is_at_source(v)) return;
  forecast_at(v);
  FrontPoint other;
  nearest_of_all(field_.target(v), other);
  if (other.distance + other.carried < field_[v].distance) field_.set(v, other);
}

/// Finds the nearest by all ways that the forecasts tell apart. Returns false if one of them is not known behind.
bool FrontMarch::nearest_of_all(const FrontTarget& target, FrontPoint& best) {
  bool all = true;
  ways_.clear();
  for (const Forecast& forecast : forecasts_) {
    if (std::ranges::any_of(ways_, [&](const Forecast& other) { return other.same_way(forecast); })) continue;
    ways_.push_back(forecast);
    const FrontPoint found = field_.arrive(target, -forecast.half);
    all &= found.known();
    if (found.distance < best.distance) best = found;
  }
  return all;
}

FrontPoint FrontMarch::at(const SurfacePoint& point, const SmoothPoint& above) {
  const EdgeCurves& curves = field_.curves();
  forecasts_.clear();
  if (curves.charts().trusts(point.face) && !curves.charts().on_face(source_, point.face))
    for (const Index v : curves.mesh().triangles()[point.face])
      if (field_[v].goes_on()) forecasts_.push_back(field_.forecast(v, above.position, above.normal));
  FrontPoint found;
  if (nearest_of_all({point, no_index, {above.position, above.normal}}, found) && forecasts_.size() == 3) return found;
  const FrontPoint path = along_path(point);
  return path.distance < found.distance + found.carried ? path : found;
}

}  // namespace geodrome
