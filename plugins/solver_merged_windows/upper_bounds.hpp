// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "plugins/common/exact/found_distance.hpp"
#include "plugins/common/mesh/for_listed_or_all.hpp"
#include "plugins/solver_merged_windows/kept_windows.hpp"

namespace geodrome::merged_windows {

/// How a way to a vertex goes back: through a kept window; along an edge, by the way `before` that its other end had
/// then; not at all, at a source; or (none of these) straight to its source.
struct Step {
  Index window = no_index, before = no_index;
  bool at_source = false;
};

/// D of every vertex, the length of the shortest way that was found to it, and, if they are kept, all ways that were
/// the shortest when they were found: a window or an edge goes on by the way of its time, even if D fell later and now
/// belongs to another source.
class UpperBounds {
 public:
  struct Way {
    Step step;
    Index vertex;  ///< to which it leads
  };

  explicit UpperBounds(std::size_t vertex_count) : found_(vertex_count) {}

  const FoundDistance& operator[](Index vertex) const { return found_[vertex]; }
  /// The number of the present way to a vertex; no_index if none are kept, or there is none.
  Index way_to(Index vertex) const { return keep_ ? present_[vertex] : no_index; }
  const Way& way(Index number) const { return ways_[number]; }

  /// Forgets what was found for these vertices: O(1) each. Keeping ways costs O(V) the first time.
  void reset(const std::vector<Index>& vertices, bool keep) {
    for_listed_or_all(vertices, found_.size(), [this](Index v) { found_[v] = {}; });
    if (!present_.empty()) for_listed_or_all(vertices, present_.size(), [this](Index v) { present_[v] = no_index; });
    ways_.clear();
    if (keep) present_.resize(found_.size(), no_index);
    keep_ = keep;
  }

  void offer(Index vertex, const FoundDistance& way, const Step& step) {
    if (!(way.distance < found_[vertex].distance)) return;
    found_[vertex] = way;
    if (keep_) keep_way(vertex, step);
  }

  std::size_t bytes() const {
    return found_.size() * sizeof(FoundDistance) + ways_.capacity() * sizeof(Way) + present_.capacity() * sizeof(Index);
  }

 private:
  /// Throws std::length_error when the numbers are used up.
  void keep_way(Index vertex, const Step& step) {
    if (ways_.size() >= no_index - way_bit) throw std::length_error("more ways than have numbers");
    present_[vertex] = static_cast<Index>(ways_.size());
    ways_.push_back({step, vertex});
  }

  std::vector<FoundDistance> found_;
  std::vector<Way> ways_;
  std::vector<Index> present_;
  bool keep_ = false;
};

}  // namespace geodrome::merged_windows
