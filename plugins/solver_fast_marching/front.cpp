// SPDX-License-Identifier: MIT
#include "solver_fast_marching/front.hpp"

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
/// base, from `from` on, in units in which the base is `rise` long.
void Front::pass(const Vertex& from, const Stencil& stencil) {
  const Vertex& target = vertices_[stencil.target];
  if (target.settled) return;
  double distance = from.distance + stencil.length;
  Index source = from.source;
  const Vertex& partner = vertices_[stencil.partner];
  if (partner.settled) {
    const double slope = partner.distance - from.distance;
    const double square = stencil.base * stencil.base - slope * slope;
    if (square > 0) {
      const double rise = std::sqrt(square), hit = stencil.along * rise - stencil.across * slope;
      const double plane = from.distance + (stencil.along * slope + stencil.across * rise);
      // Where an obtuse corner was left, a plane front can be below what is settled.
      if (hit > 0 && hit < rise && plane >= from.distance && plane < distance) {
        distance = plane;
        if (2 * hit > rise) source = partner.source;
      }
    }
  }
  if (target.straight && target.source == source) return;
  lower(stencil.target, distance, source);
}

void Front::march(double radius, bool stop_at_wanted, const RunContext& context) {
  double limit = radius;
  while (!heap_.empty() && heap_.top_key() <= limit) {
    const Index vertex = heap_.pop();
    vertices_[vertex].settled = true;
    settled_.push_back(vertex);
    if (settled_.size() % poll_interval == 0) context.throw_if_cancelled();
    const Vertex from = vertices_[vertex];
    if (from.wanted) --open_wanted_;
    if (stop_at_wanted && open_wanted_ == 0) limit = std::min(limit, from.distance);
    for (const Stencil& stencil : stencils_.of(vertex)) pass(from, stencil);
  }
}

}  // namespace geodrome
