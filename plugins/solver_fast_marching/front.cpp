// SPDX-License-Identifier: MIT
#include "plugins/solver_fast_marching/front.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome {
namespace {

constexpr std::size_t poll_interval = 4096;

}  // namespace

void Front::clear() {
  for (const Index v : touched_) vertices_[v] = {};
  touched_.clear();
  settled_.clear();
  heap_.clear();
  open_wanted_ = 0;
}

void Front::lower(Index vertex, double distance, Index source) {
  Vertex& v = vertices_[vertex];
  if (distance > v.distance || (distance == v.distance && source >= v.source)) return;
  if (v.source == no_index) touched_.push_back(vertex);
  v.distance = distance, v.source = source, v.straight = false;
  heap_.push(vertex, distance);
}

void Front::seed(Index vertex, double distance, Index source) {
  lower(vertex, distance, source);
  Vertex& v = vertices_[vertex];
  v.straight = v.straight || (v.distance == distance && v.source == source);
}

void Front::want(Index vertex) {
  if (vertices_[vertex].wanted) return;
  vertices_[vertex].wanted = true;
  touched_.push_back(vertex);
  ++open_wanted_;
}

/// `from` was settled last, so its partner, if settled, is not farther. The front through both is plane: its slope
/// along the base is that of their distances, and it moves at speed 1. `hit` is where the way to the target crosses the
/// base, from `from` on, in units in which the base is `rise` long. A partner that is not settled is at infinity, where
/// the slope is too steep for any front.
void Front::pass(const Vertex& from, const Stencil& stencil, const Vertex& target, Offer& best) const {
  const bool not_shorter = target.straight && target.source == from.source;
  const double edge = from.distance + stencil.length;
  if (edge < best.distance && !not_shorter) best = {edge, from.source};
  const Vertex& partner = vertices_[stencil.partner];
  if (not_shorter && partner.source == from.source) return;
  const double slope = partner.settled - from.distance, square = stencil.base * stencil.base - slope * slope;
  if (!(square > 0)) return;
  const double rise = std::sqrt(square), hit = stencil.along * rise - stencil.across * slope;
  const double plane = from.distance + (stencil.along * slope + stencil.across * rise);
  // Where an obtuse corner was left, a plane front can be below what is settled.
  if (hit > 0 && hit < rise && plane >= from.distance && plane < best.distance)
    best = {plane, 2 * hit > rise ? partner.source : from.source};
}

/// The stencils of a vertex come target by target: each target is lowered once.
void Front::pass_on(const Vertex& from, std::span<const Stencil> stencils) {
  for (std::size_t i = 0; i < stencils.size();) {
    const Index target = stencils[i].target;
    Offer best;
    if (vertices_[target].settled < unreached)
      while (i < stencils.size() && stencils[i].target == target) ++i;
    else
      for (; i < stencils.size() && stencils[i].target == target; ++i) pass(from, stencils[i], vertices_[target], best);
    if (best.source != no_index) lower(target, best.distance, best.source);
  }
}

void Front::march(double radius, bool stop_at_wanted, const RunContext& context) {
  double limit = radius;
  while (!heap_.empty() && heap_.top_key() <= limit) {
    const Index vertex = heap_.pop();
    vertices_[vertex].settled = vertices_[vertex].distance;
    settled_.push_back(vertex);
    if (settled_.size() % poll_interval == 0) context.throw_if_cancelled();
    const Vertex from = vertices_[vertex];
    if (from.wanted) --open_wanted_;
    if (stop_at_wanted && open_wanted_ == 0) limit = std::min(limit, from.distance);
    pass_on(from, stencils_.of(vertex));
  }
}

}  // namespace geodrome
