// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plugins/solver_merged_windows/pair.hpp"
#include "plugins/solver_merged_windows/window.hpp"

namespace geodrome::merged_windows {

/// Makes neighbouring windows of a half-edge into one, so that L is nowhere higher than before and U nowhere lower, and
/// the slack stays within `delta` times L. PROOF.md shows that then every vertex v has a value l(v), the least L, with
/// l(v) <= d(v) <= D(v) <= (1 + delta) l(v). One per thread.
class Merging {
  struct Ends;

 public:
  struct Counts {
    std::uint64_t tried = 0, done = 0;
  };

  explicit Merging(double delta) : delta_(delta) {}

  /// A half-edge, and how near a line through a point of it, inside the face below, lets the corner at that point be
  /// cut, as a share of the point's distance from the nearer end: the sine of the smaller angle of that face at the
  /// ends of the half-edge, with 1 for an obtuse one.
  struct Edge {
    double length, sine;
  };

  /// Parts the ordered, disjoint windows of a half-edge into groups, each as long as it can be, and puts one window in
  /// the place of each. Two neighbours get into one group only if `may_join(left, right)`. Windows [first, last) that
  /// become one are told before: `on_merge(first, last)` returns the parent of that one. O(n).
  template <class MayJoin, class OnMerge>
  void merge(std::vector<Window>& windows, const Edge& edge, MayJoin&& may_join, OnMerge&& on_merge) {
    list_ends(windows);
    for (std::size_t i = 0; i + 1 < windows.size(); ++i)
      ends_[i].joins_next = edge.sine > 0 && may_join(windows[i], windows[i + 1]) &&
                            !is_hopeless(windows[i], windows[i + 1], edge.length, Seam(ends_[i], ends_[i + 1]));
    std::size_t done = 0;
    for (std::size_t first = 0, most = windows.size(); first < windows.size();) {
      Window window;
      const std::size_t last = group_from(windows, first, most, edge, window);
      if (last > first + 1) window.parent = on_merge(first, last);
      windows[done++] = last > first + 1 ? window : windows[first];
      most = 2 * (last - first);
      first = last;
    }
    windows.resize(done);
  }

  /// L and its slope where two neighbours meet.
  struct Seam {
    Two l, slope;

    explicit Seam(const Pair& pair);
    Seam(const Ends& left, const Ends& right);
  };
  /// Whether two neighbours cannot get into one group: L bends too much at their seam, or they do not touch.
  bool is_hopeless(const Window& left, const Window& right, double length, const Seam& seam);
  /// What `merge` does with two neighbours that may join; false if they do not become one, the first.
  bool merge_two(std::array<Window, 2>& windows, const Edge& edge, const Seam& seam);

  const Counts& counts() const { return counts_; }
  void reset() { counts_ = {}; }
  std::size_t bytes() const { return ends_.capacity() * sizeof(Ends); }

 private:
  /// Of a window: L and its slope along the half-edge at both ends.
  struct Ends {
    double l_low, l_high, slope_low, slope_high;
    bool joins_next = false;
  };
  /// L of a merged window and its slope at a place.
  struct Place {
    double l, slope;
  };
  /// The largest differences between old windows and the one that they become.
  struct Differences {
    double rise = 0, drop = 0;  ///< of L
    double slack = 0;           ///< with which U nowhere falls
    double turn = 0;            ///< between slopes anywhere in a piece
    double jump = 0;            ///< of the old L from window to window
    double steepest = 0;        ///< slope
  };
  enum class Fit {
    fits,
    above,  ///< L is higher somewhere
    costly  ///< L falls more than slack or condition 3 of the proof allow
  };

  void list_ends(std::span<const Window> windows);
  static bool touch(const Window& left, const Window& right, double length);
  std::size_t group_from(std::span<const Window> windows, std::size_t first, std::size_t most, const Edge& edge,
                         Window& window);
  bool merged(std::span<const Window> windows, const Ends* ends, const Edge& edge, Window& window) const;
  static void compare(const Window& old, const Ends& ends, const Window& merged, const Place& low, const Place& high,
                      Differences& all);
  Fit settle(std::span<const Window> windows, const Ends* ends, const Edge& edge, Window& merged) const;

  double delta_;
  std::vector<Ends> ends_;
  Counts counts_;
};

}  // namespace geodrome::merged_windows
