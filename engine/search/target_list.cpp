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
