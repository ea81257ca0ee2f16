// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plugins/solver_merged_windows/window.hpp"

namespace geodrome::merged_windows {

/// Makes neighbouring windows of a half-edge into one, so that L is nowhere higher than before and U nowhere lower, and
/// the slack stays within `delta` times L. README.md proves that then every vertex v has a value l(v), the least L, with
/// l(v) <= d(v) <= D(v) <= (1 + delta) l(v). One per thread.
class Merging {
 public:
  struct Counts {
    std::uint64_t tried = 0, done = 0;
  };

  explicit Merging(double delta) : delta_(delta) {}

  /// Where a merged window begins and ends among the windows that were given.
  struct Group {
    std::size_t first, last;  ///< [first, last)
    Window window;            ///< that of `first` where last == first + 1
  };

  /// A half-edge, and how near a line through a point of it, inside the face below, lets the corner at that point be
  /// cut, as a share of the point's distance from the nearer end: the sine of the smaller angle of that face at the ends
  /// of the half-edge, with 1 for an obtuse one.
  struct Edge {
    double length, sine;
  };

  /// Parts the ordered, disjoint windows of a half-edge into groups, each as long as it can be. Two neighbours get into
  /// one group only if `may_join(left, right)`. The groups are valid until the next call. O(n).
  template <class MayJoin>
  std::span<const Group> group(std::span<const Window> windows, const Edge& edge, MayJoin&& may_join) {
    ends_.clear();
    for (std::size_t i = 0; i < windows.size(); ++i) {
      ends_.push_back(ends_of(windows[i]));
      if (i > 0) ends_[i - 1].joins_next = touch(windows[i - 1], windows[i], edge) && may_join(windows[i - 1], windows[i]);
    }
    part(windows, edge);
    return groups_;
  }

  const Counts& counts() const { return counts_; }
  void reset() { counts_ = {}; }
  std::size_t bytes() const { return groups_.capacity() * sizeof(Group) + ends_.capacity() * sizeof(Ends); }

 private:
  /// Of a window: L and its slope along the half-edge at both ends.
  struct Ends {
    double l_low, l_high, slope_low, slope_high;
    bool joins_next = false;
  };
  enum class Fit { fits, above, costly };

  static Ends ends_of(const Window& window);
  static bool touch(const Window& left, const Window& right, const Edge& edge);
  void part(std::span<const Window> windows, const Edge& edge);
  std::optional<Window> merged(std::span<const Window> windows, const Ends* ends, const Edge& edge) const;
  Fit settle(std::span<const Window> windows, const Ends* ends, const Edge& edge, Window& merged) const;

  double delta_;
  std::vector<Ends> ends_;
  std::vector<Group> groups_;
  Counts counts_;
};

}  // namespace geodrome::merged_windows
