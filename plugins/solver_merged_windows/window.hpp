// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geodrome/geometry.hpp"
#include "plugins/common/exact/entry.hpp"

namespace geodrome::merged_windows {

/// A window: straight lines that cross a half-edge within [low, high] and enter its face, as if they came from one
/// image. In the frame of the half-edge (origin at its start, face above) the image is at (x, y), y <= 0. At a point p
/// that such a line reaches
///
///   L(p) = sigma + |image p| is what all decisions compare, and
///   U(p) = L(p) + slack is never below the length of a path that exists.
///
/// The image of a window that was never merged is a pseudo-source, unfolded. One cache line.
struct alignas(64) Window {
  double x, y, sigma, low, high;
  double slack;                       ///< >= 0
  Index origin;                       ///< `vertex count + i` for source i of the request, from which the way of U comes
  Index parent;                       ///< in a run that keeps windows, what U goes on through (kept_windows.hpp)
  Index next;                         ///< in a chain of waiting windows
  std::uint32_t depth : 28;           ///< faces its lines have crossed since the pseudo-source; at most `deepest`
  std::uint32_t entry_bits : 2;       ///< `entry`
  std::uint32_t ends_run : 1;         ///< in a chain: what follows is in no order with the windows up to this one
  std::uint32_t from_face_below : 1;  ///< its source lies inside the face below

  static constexpr std::uint32_t deepest = (1U << 28) - 1;

  /// How its lines entered the face below.
  Entry entry() const { return static_cast<Entry>(entry_bits); }
  /// Marks that it has crossed its faces so far, the last of which it entered so.
  void enter(Entry entry, std::uint32_t faces) { depth = faces & deepest, from_face_below = 0, set_entry(entry); }
  void set_entry(Entry entry) { entry_bits = static_cast<std::uint32_t>(entry) & 3U; }

  /// L of a point, if a line of the window goes there.
  double to(double px, double py) const { return sigma + std::sqrt((px - x) * (px - x) + (py - y) * (py - y)); }
  /// The same for a point of the half-edge.
  double at(double px) const { return to(px, 0); }
  bool empty() const { return !(low < high); }
};
static_assert(sizeof(Window) == 64);

/// The memory of waiting windows; nothing is given back before the end.
class WindowPool {
 public:
  const Window& operator[](Index i) const { return windows_[i]; }
  Window& operator[](Index i) { return windows_[i]; }

  /// The number of a window whose members have any value. References to others are void.
  Index add() {
    if (free_ == no_index) {
      windows_.emplace_back();
      return static_cast<Index>(windows_.size() - 1);
    }
    const Index window = free_;
    free_ = windows_[window].next;
    return window;
  }
  void release(Index window) {
    windows_[window].next = free_;
    free_ = window;
  }

  std::size_t bytes() const { return windows_.capacity() * sizeof(Window); }

 private:
  std::vector<Window> windows_;
  Index free_ = no_index;
};

}  // namespace geodrome::merged_windows
