// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "plugins/common/exact/found_distance.hpp"
#include "plugins/common/mesh/for_listed_or_all.hpp"

namespace geodrome::merged_windows {

/// How a path goes on from a vertex: through a kept window, along an edge to another vertex, not at all (`vertex` is
/// the vertex itself: a source), or (neither) straight to its source.
struct Step {
  Index window = no_index, vertex = no_index;
};

/// D of every vertex: the length of the shortest path that was found to it, and how that path goes on.
class UpperBounds {
 public:
  explicit UpperBounds(std::size_t vertex_count) : found_(vertex_count) {}

  const FoundDistance& operator[](Index vertex) const { return found_[vertex]; }
  const Step& step(Index vertex) const { return steps_[vertex]; }

  /// Forgets what was found for these vertices.
  void reset(const std::vector<Index>& vertices, bool with_steps) {
    for_listed_or_all(vertices, found_.size(), [this](Index v) { found_[v] = {}; });
    if (with_steps) steps_.resize(found_.size());
    with_steps_ = with_steps;
  }

  void offer(Index vertex, const FoundDistance& way, const Step& step) {
    if (!(way.distance < found_[vertex].distance)) return;
    found_[vertex] = way;
    if (with_steps_) steps_[vertex] = step;
  }

  std::size_t bytes() const { return found_.size() * sizeof(FoundDistance) + steps_.size() * sizeof(Step); }

 private:
  std::vector<FoundDistance> found_;
  std::vector<Step> steps_;
  bool with_steps_ = false;
};

}  // namespace geodrome::merged_windows
