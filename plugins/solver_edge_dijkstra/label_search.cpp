// SPDX-License-Identifier: MIT
#include "plugins/solver_edge_dijkstra/label_search.hpp"

#include <algorithm>

namespace geodrome {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();
constexpr std::uint64_t poll_interval = 4096;

}  // namespace

LabelSearch::LabelSearch(const EdgeGraph& graph)
    : graph_(graph),
      distance_(graph.vertex_count(), unreached),
      source_(graph.vertex_count(), no_index),
      previous_(graph.vertex_count(), no_index),
      wanted_(graph.vertex_count(), 0),
      place_(graph.vertex_count(), static_cast<std::size_t>(-1)),
      heap_(distance_.data(), Places(place_.data(), {})) {}

void LabelSearch::clear() {
  while (!heap_.empty()) heap_.pop();
  for (const Index v : touched_) distance_[v] = unreached, source_[v] = previous_[v] = no_index, wanted_[v] = 0;
  touched_.clear();
  open_wanted_ = 0;
  settled_ = 0;
}

void LabelSearch::want(Index vertex) {
  if (wanted_[vertex]) return;
  wanted_[vertex] = 1;
  touched_.push_back(vertex);
  ++open_wanted_;
}

void LabelSearch::relax(Index vertex, double distance, Index source, Index previous) {
  const double old = distance_[vertex];
  if (distance > old || (distance == old && source >= source_[vertex])) return;
  if (old == unreached) touched_.push_back(vertex);
  distance_[vertex] = distance;
  source_[vertex] = source;
  previous_[vertex] = previous;
  heap_.push_or_update(vertex);
}

void LabelSearch::run(double radius, bool stop_at_wanted, const RunContext& context) {
  limit_ = radius;
  while (!heap_.empty() && distance_[heap_.top()] <= limit_) {
    const Index vertex = heap_.top();
    heap_.pop();
    if (++settled_ % poll_interval == 0) context.throw_if_cancelled();
    if (wanted_[vertex]) wanted_[vertex] = 0, --open_wanted_;
    if (stop_at_wanted && open_wanted_ == 0) limit_ = std::min(limit_, distance_[vertex]);
    for (const auto& [to, length] : graph_.arcs(vertex)) relax(to, distance_[vertex] + length, source_[vertex], vertex);
  }
  drop_unsettled();
}

/// The heap compares labels while it shrinks, so a label stays until its vertex is out.
void LabelSearch::drop_unsettled() {
  while (!heap_.empty()) {
    const Index vertex = heap_.top();
    heap_.pop();
    distance_[vertex] = unreached;
    source_[vertex] = previous_[vertex] = no_index;
  }
}

}  // namespace geodrome
