// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "plugins/solver_merged_windows/window.hpp"

namespace geodrome::merged_windows {

/// What a window came from, as its `parent`: a kept window, or with this bit the way to a vertex (upper_bounds.hpp).
/// no_index, which has the bit, is a source that is no vertex.
inline constexpr Index way_bit = Index{1} << 31;

/// A window that was carried on, or one that was merged into such a window.
struct KeptWindow {
  double x, y, sigma, low, high, slack;
  Index origin;
  /// What it came from. Of a merged window: the first of those that it was made of, which are at the same half-edge and
  /// follow each other.
  Index parent;

  bool came_from_window() const { return (parent & way_bit) == 0; }
  /// The way on which it came, no_index if straight from a source. Precondition: it came from no window.
  Index way() const { return parent == no_index ? no_index : parent & ~way_bit; }

  double to(double px, double py) const { return sigma + std::sqrt((px - x) * (px - x) + (py - y) * (py - y)); }
};

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
  /// Called before the first `begin_pass` and `for_each`. O(half-edges) the first time.
  void prepare(std::size_t half_edge_count) { last_.resize(half_edge_count, no_index); }

  /// What is added from now on is at this half-edge: first windows that were merged, then, after `carried_from_here`,
  /// those that are carried on.
  void begin_pass(Index half_edge) {
    const Index first = static_cast<Index>(size_);
    passes_.push_back({half_edge, first, first, last_[half_edge]});
    last_[half_edge] = static_cast<Index>(passes_.size() - 1);
  }
  void carried_from_here() { passes_.back().first_carried = static_cast<Index>(size_); }
  /// Returns its number. Throws std::length_error when the numbers are used up.
  Index add(const Window& window);

  const KeptWindow& operator[](Index window) const { return pages_[window / page_size][window % page_size]; }
  Index half_edge_of(Index window) const {
    const auto after = std::upper_bound(passes_.begin(), passes_.end(), window,
                                        [](Index w, const Pass& pass) { return w < pass.first; });
    return (after - 1)->half_edge;
  }

  /// Calls `visit(number, window)` for every window of a half-edge that was carried on.
  template <class Visit>
  void for_each(Index half_edge, Visit&& visit) const {
    for (Index p = last_[half_edge]; p != no_index; p = passes_[p].before) {
      const Index end = p + 1 < passes_.size() ? passes_[p + 1].first : static_cast<Index>(size_);
      for (Index w = passes_[p].first_carried; w < end; ++w) visit(w, (*this)[w]);
    }
  }

  std::size_t bytes() const {
    return pages_.size() * page_size * sizeof(KeptWindow) + passes_.capacity() * sizeof(Pass) +
           last_.capacity() * sizeof(Index);
  }

 private:
  static constexpr std::size_t page_size = 1 << 12;
  struct Pass {
    Index half_edge, first, first_carried, before;  ///< the pass before on the same half-edge
  };

  std::vector<std::unique_ptr<KeptWindow[]>> pages_;
  std::size_t size_ = 0;
  std::vector<Pass> passes_;
  std::vector<Index> last_;
};

/// Returns U of the way through a window, waiting or kept, to a point (px, py) in its face: straight if a line of the
/// window goes there, else bent at its nearer end. Never below the length of a path that exists.
template <class AnyWindow>
double way_through(const AnyWindow& w, double px, double py) {
  const double climb = py - w.y;
  const double x = climb > 0 ? w.x + (px - w.x) * (-w.y / climb) : px;
  if (x >= w.low && x <= w.high) return w.to(px, py) + w.slack;
  const double end = x < w.low ? w.low : w.high;
  return w.to(end, 0) + std::sqrt((px - end) * (px - end) + py * py) + w.slack;
}

}  // namespace geodrome::merged_windows
