// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/bounded_search.hpp"

#include <algorithm>
#include <utility>

namespace geodrome::merged_windows {

BoundedSearch::BoundedSearch(std::shared_ptr<const PackedMesh> surface, const Settings& settings)
    : surface_(std::move(surface)), settings_(settings), search_(surface_, settings) {}

const ShortestPathMap& BoundedSearch::run(std::span<const Source> sources, const Request& request,
                                          RunContext& context) {
  radius_ = request.radius;
  Request wider = request;
  // A middle within the radius belongs to a D of up to 1 + delta times as much, which must be the D of a whole search.
  if (is_middle()) wider.radius *= 1 + settings_.delta;
  upper_ = &search_.run(sources, wider, context);
  if (is_middle()) write_middles();
  return *this;
}

void BoundedSearch::write_middles() {
  const std::span<const double> upper = upper_->vertices();
  middles_.resize(upper.size());
  search_.write_lower_bounds(middles_);
  for (std::size_t v = 0; v < upper.size(); ++v) {
    const double middle = (middles_[v] + upper[v]) / 2;
    middles_[v] = middle > radius_ ? infinity : middle;
  }
}

Distance BoundedSearch::at(const SurfacePoint& point) const {
  Distance distance = upper_->at(point);
  if (!is_middle() || distance.reach != Reach::reached) return distance;
  const Index vertex = surface_->mesh().vertex_at(point);
  distance.value = vertex == no_index ? (distance.value / search_.factor() + distance.value) / 2 : middles_[vertex];
  return distance.value > radius_ ? Distance{infinity, Reach::beyond_limit, no_index} : distance;
}

void BoundedSearch::path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const {
  upper_->path(point, out);
  if (is_middle() && at(point).reach != Reach::reached) out.clear();
}

void BoundedSearch::write_lower_bounds(std::span<double> bounds) const { search_.write_lower_bounds(bounds); }

double BoundedSearch::lower_bound_at(const SurfacePoint& point) const {
  const Distance distance = upper_->at(point);
  const Index vertex = surface_->mesh().vertex_at(point);
  if (vertex != no_index) return search_.lower_bound(vertex);
  if (distance.reach == Reach::unreachable) return infinity;
  return std::min(distance.value, search_.complete_up_to()) / search_.factor();
}

}  // namespace geodrome::merged_windows
