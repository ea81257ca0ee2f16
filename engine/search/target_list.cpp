// SPDX-License-Identifier: MIT
#include "engine/search/target_list.hpp"

#include <algorithm>
#include <cmath>

#include "engine/search/distances.hpp"

namespace geodrome {

namespace {

bool is_no_vertex(const NamedPoint& point) {
  return point.place.state == Place::State::on_surface && point.place.vertex == no_index;
}

/// Where the smooth surface is above points of a mesh; nothing is known above faces that are not trusted.
std::vector<SmoothPoint> points_above(std::span<const SurfacePoint> points, const PlacedSurface& surface) {
  const SmoothSurface& smooth = *surface.smooth->surface;
  std::vector<SmoothPlace> places;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [p, q, r] = surface.mesh->corners(points[k].face);
    if (!(smooth.deviation(points[k].face) < infinity) || squared_norm(cross(q - p, r - p)) == 0) continue;
    places.push_back({points[k], (q - p) / norm(q - p)}), number.push_back(k);
  }
  std::vector<SmoothPoint> found(places.size()), above(points.size());
  cross_boundary(surface.smooth->record.plugin, [&] { smooth.evaluate(places, found); });
  for (std::size_t i = 0; i < found.size(); ++i) above[number[i]] = found[i];
  return above;
}

}  // namespace

TargetList::TargetList(std::vector<NamedPoint> targets, const PlacedSurface& surface)
    : named_(std::move(targets)),
      bounded_(surface.made_from == InputKind::points || surface.smooth),
      one_point_each_(true) {
  for (const NamedPoint& target : named_) {
    first_.push_back(points_.size());
    if (is_no_vertex(target)) points_.push_back(target.place.at);
  }
  first_.push_back(points_.size());
  for (std::size_t j = 0; j < named_.size(); ++j)
    if (is_no_vertex(named_[j])) by_face_.push_back(j);
  std::ranges::sort(by_face_, {}, [&](std::size_t j) { return std::pair(named_[j].place.at.face, j); });
  if (surface.smooth) above_ = points_above(points_, surface);
}

TargetList::TargetList(std::vector<NamedPoint> targets, const std::vector<std::vector<SurfacePoint>>& points)
    : named_(std::move(targets)), bounded_(false), one_point_each_(false) {
  for (const auto& of_target : points) {
    first_.push_back(points_.size());
    points_.insert(points_.end(), of_target.begin(), of_target.end());
  }
  first_.push_back(points_.size());
}

double TargetList::read(const ShortestPathMap& map, std::size_t j) const {
  const auto checked = [&](double value) {
    if (!is_distance(value)) throw_no_distance(value, "target " + named_[j].label);
    return value;
  };
  if (const Index vertex = named_[j].place.vertex; vertex != no_index) return checked(map.vertices()[vertex]);
  double least = infinity;
  for (std::size_t k = first_[j]; k < first_[j + 1]; ++k) least = std::min(least, checked(map.at(points_[k]).value));
  return least;
}

void check_provides(const PluginInfo& solver, ProjectionRule rule, std::span<const NamedPoint> sources,
                    std::span<const NamedPoint> targets, double max_distance) {
  if (rule == ProjectionRule::project && std::ranges::any_of(sources, is_no_vertex))
    demand(solver, Provides::face_sources);
  if (std::ranges::any_of(targets, is_no_vertex)) demand(solver, Provides::any_point);
  if (std::isfinite(max_distance)) demand(solver, Provides::radius_limit);
}

}  // namespace geodrome
