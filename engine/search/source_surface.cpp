// SPDX-License-Identifier: MIT
#include "engine/search/source_surface.hpp"

#include <algorithm>

#include "engine/search/relocation.hpp"

namespace geodrome {

namespace {

Place at_vertex(Place place, const SurfaceMesh& mesh, Index vertex) {
  place.at = mesh.at_vertex(vertex);
  place.vertex = vertex;
  return place;
}

/// A plugin may be anybody's: a surface that breaks the interface must not travel on.
void check(const Inserted& got, const MeshPtr& old, const PluginInfo& plugin) {
  const auto demand = [&](bool holds, const char* what) {
    if (holds) return;
    PluginError error(std::string("inserted a point and returned ") + what,
                      "report this to the author of " + plugin.file.string());
    error.attribute_to(plugin.full_name());
    throw error;
  };
  demand(got.mesh != nullptr, "no surface");
  const SurfaceMesh& mesh = *got.mesh;
  demand(got.vertex < mesh.vertex_count() && mesh.first_half_edge(got.vertex) != no_index, "no vertex of a face");
  if (got.mesh == old) return;
  demand(mesh.vertex_count() == old->vertex_count() + 1 && got.vertex == old->vertex_count() &&
             std::equal(old->positions().begin(), old->positions().end(), mesh.positions().begin()),
         "other vertices than the old ones and the new one");
  demand(mesh.manifold() && mesh.oriented(), "a surface that is no oriented 2-manifold");
  demand(mesh.face_weights().empty(), "a surface with weights");
  demand(mesh.closed() == old->closed(), "a surface with a boundary where there was none, or without the one it had");
}

}  // namespace

SourceSurfaces::SourceSurfaces(ProjectionRule rule, const Opened& opened, std::vector<NamedPoint> targets)
    : rule_(rule), opened_(opened), targets_(std::make_shared<const TargetList>(std::move(targets), opened.surface)) {
  if (rule_ != ProjectionRule::printed) return;
  const std::vector<Index>& element_of_vertex = opened.surface.sample->sample_of_vertex;
  vertex_of_element_.assign(opened.input.positions.size(), no_index);
  for (Index v = 0; v < element_of_vertex.size(); ++v)
    if (element_of_vertex[v] != no_index) vertex_of_element_[element_of_vertex[v]] = v;
  const VertexLocator vertices(*opened.surface.mesh);
  for (const NamedPoint& target : targets_->named())
    nearest_.push_back(target.place.state == Place::State::on_surface ? vertices.nearest(target.place.position)
                                                                      : no_index);
}

Index SourceSurfaces::element_of(const NamedPoint& point) const {
  return point.row == no_index ? no_index : opened_.input.element_of_row[point.row];
}

Inserted SourceSurfaces::insert(Index element) const {
  const PluginInfo& reconstructor = opened_.surface.stages.back().plugin;
  Inserted got = cross_boundary(reconstructor, [&] { return opened_.surface.inserter->with(element); });
  check(got, reconstruction(), reconstructor);
  return got;
}

SourceSurface SourceSurfaces::of(const NamedPoint& source) const {
  SourceSurface on{reconstruction(), source, targets_};
  if (rule_ == ProjectionRule::project || source.place.state != Place::State::on_surface) return on;
  const Index element = element_of(source);
  const Inserted got = insert(element);
  on.mesh = got.mesh, on.how = got.how;
  on.source.place = at_vertex(source.place, *on.mesh, got.vertex);
  const bool as_projected = on.mesh == reconstruction() && source.place.vertex == got.vertex;
  if (rule_ == ProjectionRule::printed)
    on.targets = printed_targets(on, element);
  else if (!as_projected)
    on.targets = inserted_targets(on, element);
  return on;
}

/// The corrected rule: closest points of the surface with the source. The source itself is the vertex it became, even
/// if smoothing moved it there.
std::shared_ptr<const TargetList> SourceSurfaces::inserted_targets(const SourceSurface& on, Index element) const {
  std::vector<NamedPoint> targets(targets_->named().begin(), targets_->named().end());
  if (on.mesh != reconstruction()) relocate(targets, *reconstruction(), *opened_.surface.locator, on.mesh);
  for (NamedPoint& target : targets)
    if (element_of(target) == element) target.place = at_vertex(target.place, *on.mesh, on.source.place.vertex);
  return std::make_shared<const TargetList>(std::move(targets), opened_.surface);
}

/// Lines 13 to 19 as printed.
std::shared_ptr<const TargetList> SourceSurfaces::printed_targets(const SourceSurface& on, Index element) const {
  const SurfaceMesh& mesh = *on.mesh;
  const Index source = on.source.place.vertex;
  std::vector<NamedPoint> targets(targets_->named().begin(), targets_->named().end());
  std::vector<std::vector<SurfacePoint>> points(targets.size());
  for (std::size_t j = 0; j < targets.size(); ++j) {
    Place& place = targets[j].place;
    if (place.state != Place::State::on_surface) continue;
    const Index own = element_of(targets[j]);
    const Index vertex = own == no_index ? no_index : own == element ? source : vertex_of_element_[own];
    if (vertex != no_index) {
      place = at_vertex(place, mesh, vertex);
      continue;
    }
    const auto to = [&](Index v) { return squared_distance(place.position, mesh.positions()[v]); };
    points[j] = closest_on_faces_at(mesh, to(source) < to(nearest_[j]) ? source : nearest_[j], place.position);
    place.at = points[j].front(), place.vertex = no_index;
  }
  return std::make_shared<const TargetList>(std::move(targets), points);
}

}  // namespace geodrome
