// SPDX-License-Identifier: MIT
#include "plugins/solver_edge_dijkstra/label_search.hpp"

#include <algorithm>

namespace geodrome {
namespace {

constexpr std::uint64_t poll_interval = 4096;

}  // namespace

LabelSearch::LabelSearch(const EdgeGraph& graph)
    : graph_(graph),
      distance_(graph.vertex_count(), infinity),
      source_(graph.vertex_count(), no_index),
      previous_(graph.vertex_count(), no_index),
      wanted_(graph.vertex_count(), 0),
      queue_(graph.vertex_count()) {}

void LabelSearch::clear() {
  queue_.clear();
  for (const Index v : touched_) distance_[v] = infinity, source_[v] = previous_[v] = no_index, wanted_[v] = 0;
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
  if (old == infinity) touched_.push_back(vertex);
  distance_[vertex] = distance;
  source_[vertex] = source;
  previous_[vertex] = previous;
  queue_.push(vertex, distance);
}

void LabelSearch::run(double radius, bool stop_at_wanted, const RunContext& context) {
  limit_ = radius;
  while (!queue_.empty() && queue_.top_key() <= limit_) {
    const Index vertex = queue_.pop();
    if (++settled_ % poll_interval == 0) context.throw_if_cancelled();
    if (wanted_[vertex]) wanted_[vertex] = 0, --open_wanted_;
    if (stop_at_wanted && open_wanted_ == 0) limit_ = std::min(limit_, distance_[vertex]);
    for (const auto& [to, length] : graph_.arcs(vertex)) relax(to, distance_[vertex] + length, source_[vertex], vertex);
  }
  drop_unsettled();
}

void LabelSearch::drop_unsettled() {
  while (!queue_.empty()) {
    const Index vertex = queue_.pop();
    distance_[vertex] = infinity;
    source_[vertex] = previous_[vertex] = no_index;
  }
}

}  // namespace geodrome
