// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/row_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/common/mesh/for_listed_or_all.hpp"

namespace geodrome::chen_han {

RowSearch::RowSearch(std::shared_ptr<const RowTables> tables)
    : KeptSearch(tables->surface->mesh(), tables->surface->components()),
      tables_(std::move(tables)),
      surface_(*tables_->surface),
      direct_(surface_, tables_->settings, tables_->ground),
      labels_(tables_->lists.lists),
      distances_(surface_.vertex_count(), infinity) {
  count(false);
}

bool RowSearch::can_run(std::span<const Source> sources, const Request& request) const {
  const auto is_vertex = [this](const SurfacePoint& point) { return mesh().vertex_at(point) != no_index; };
  const auto on_mesh = [this](const SurfacePoint& point) { return point.face < mesh().triangles().size(); };
  if (sources.size() != 1 || request.keep != Keep::targets || !on_mesh(sources[0].at)) return false;
  const Index vertex = mesh().vertex_at(sources[0].at);
  if (vertex == no_index || !tables_->is_source[surface_.vertex_of_original(vertex)]) return false;
  if (std::ldexp(request.radius - sources[0].start, surface_.exponent()) > tables_->distance) return false;
  return std::all_of(request.targets.begin(), request.targets.end(),
                     [&](const SurfacePoint& target) { return on_mesh(target) && is_vertex(target); });
}

void RowSearch::search(const Request& request, RunContext& context) {
  const Index source = surface_.vertex_of_original(mesh().vertex_at(sources()[0].at));
  const double start = std::ldexp(sources()[0].start, surface_.exponent());
  const double limit = std::ldexp(radius(), surface_.exponent());
  const bool has_list = surface_.kind(source) != PackedMesh::VertexKind::smooth;
  if (has_list)
    labels_.begin(source, start);
  else
    labels_.begin(source, start, direct_.run(source, limit - start, context));
  labels_.run(limit, context, [&] { return request.stop_at_targets ? farthest_target(request) : infinity; });
  limit_ = request.stop_at_targets ? farthest_target(request) : infinity;
  write_distances();
  count(!has_list);
}

double RowSearch::farthest_target(const Request& request) const {
  double farthest = 0;
  for (const SurfacePoint& target : request.targets)
    farthest = std::max(farthest, labels_.distance(surface_.vertex_of_original(mesh().vertex_at(target))));
  return farthest;
}

void RowSearch::write_distances() {
  const double units = std::ldexp(1.0, surface_.exponent());
  for_listed_or_all(written_, distances_.size(), [&](Index v) { distances_[v] = infinity; });
  written_.clear();
  for_listed_or_all(labels_.reached(), distances_.size(), [&](Index v) {
    const double inner = labels_.distance(v), value = inner / units;
    if (inner == infinity || value > radius() || inner > limit_) return;
    written_.push_back(surface_.original_vertex(v));
    distances_[written_.back()] = value;
  });
}

/// The counters of the direct search are 0 where the source has a list.
void RowSearch::count(bool searched) {
  const auto direct = direct_.propagation().counters();
  std::copy(direct.begin(), direct.end() - 1, counters_.begin());
  if (!searched)
    for (Counter& counter : counters_) counter.value = 0;
  counters_[direct.size() - 1] = {"list_vertices_settled", labels_.counts().settled};
  counters_[direct.size()] = {"list_paths_tried", labels_.counts().relaxed};
  counters_.back() = {"largest_search_bytes",
                      direct_.bytes() + labels_.bytes() + distances_.size() * (sizeof(double) + sizeof(Index))};
}

Distance RowSearch::distance_at(const SurfacePoint& point) const {
  const double value = distances_[mesh().vertex_at(point)];
  return value < infinity ? Distance{value, Reach::reached, 0} : no_distance(point.face);
}

}  // namespace geodrome::chen_han
