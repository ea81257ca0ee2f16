// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "plugins/common/mesh/labels.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// The windows that were carried on, numbered in that order, by half-edge: the shortest-path map. Reused from run to
/// run; its memory stays.
class KeptWindows {
 public:
  /// Makes it empty. O(what it held).
  void reset() {
    for (const Pass& pass : passes_) last_[pass.half_edge] = no_index;
    passes_.clear();
    size_ = 0;
  }
  /// Called before the first `keep` and `for_each`. O(half-edges) the first time.
  void prepare(std::size_t half_edge_count) { last_.resize(half_edge_count, no_index); }

  /// Keeps windows under a half-edge; returns the number of the first. Throws std::length_error when the
  /// numbers are used up.
  Index keep(Index half_edge, const WindowArrays& windows, std::size_t count);

  std::size_t size() const { return size_; }
  const Window& operator[](Index window) const { return pages_[window / page_size][window % page_size]; }
  Index half_edge_of(Index window) const {
    const auto after = std::upper_bound(passes_.begin(), passes_.end(), window,
                                        [](Index w, const Pass& pass) { return w < pass.first; });
    return (after - 1)->half_edge;
  }

  /// Calls `visit(number, window)` for every window of a half-edge.
  template <class Visit>
  void for_each(Index half_edge, Visit&& visit) const {
    for (Index p = last_[half_edge]; p != no_index; p = passes_[p].before) {
      const Index end = p + 1 < passes_.size() ? passes_[p + 1].first : static_cast<Index>(size_);
      for (Index w = passes_[p].first; w < end; ++w) visit(w, (*this)[w]);
    }
  }

  std::size_t bytes() const {
    return pages_.size() * page_size * sizeof(Window) + passes_.capacity() * sizeof(Pass) +
           last_.capacity() * sizeof(Index);
  }

 private:
  static constexpr std::size_t page_size = 1 << 12;
  struct Pass {
    Index half_edge, first, before;  ///< its first window; the pass before on the same half-edge
  };

  std::vector<std::unique_ptr<Window[]>> pages_;
  std::size_t size_ = 0;
  std::vector<Pass> passes_;
  std::vector<Index> last_;
};

/// How a path goes on from a vertex: through a kept window, along an edge to another vertex, or (neither) straight to
/// its source.
struct Step {
  Index window = no_index, vertex = no_index;
};

using Labels = geodrome::Labels<Step>;

/// The length of the way through a window to a point (px, py) in its face: straight if a line of the window goes there,
/// else bent at its nearer end. Always the length of a path that exists. `best` bounds what is of interest: a window
/// that is not below may return any value that is not.
inline double way_through(const Window& w, double px, double py, double best) {
  const double straight = w.to(px, py);
  if (!(straight < best)) return straight;
  const double climb = py - w.y;
  const double x = climb > 0 ? w.x + (px - w.x) * (-w.y / climb) : px;
  if (x >= w.low && x <= w.high) return straight;
  const double end = x < w.low ? w.low : w.high;
  return w.at(end) + std::sqrt((px - end) * (px - end) + py * py);
}

}  // namespace geodrome::chen_han
