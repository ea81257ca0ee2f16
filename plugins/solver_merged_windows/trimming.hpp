// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plugins/solver_merged_windows/window.hpp"

namespace geodrome::merged_windows {

using WindowList = std::vector<Window>;

/// Which of two windows remain after trimming; `unsettled`: they cannot be put in order and are as they were.
enum class Remains { both, left, right, none, unsettled };

/// Cuts windows of one half-edge against each other by their L, so that no part that is not lowest there is carried on.
/// "Ordered" means: in the order in which their lines enter the face below. One per thread.
class Trimming {
 public:
  /// Trims two ordered windows of one half-edge.
  Remains settle(Window& left, Window& right);

  /// Trims ordered windows that may overlap until they are disjoint and ascending, and drops what is left empty. The
  /// list is ordered between the positions in `breaks` only.
  void trim(WindowList& list);
  const std::vector<std::uint32_t>& breaks() const { return breaks_; }

  /// Trims at the seam of the two ordered rows of disjoint windows that `list` holds, the second of which begins at
  /// `middle` and enters to the right of the first. False if they cannot be put in order: then the second row is as it
  /// was, and the first is without what is not needed.
  bool join(WindowList& list, std::size_t& middle);

  /// Merges disjoint, ascending windows of which nothing is known about how they enter into a list of such: at every
  /// point the lower one stays. A window may come out in pieces. O(n + m).
  void merge(WindowList& list, std::span<const Window> other);

  std::uint64_t dropped() const { return dropped_; }
  void reset() { dropped_ = 0; }

 private:
  std::vector<std::uint32_t> breaks_;
  std::vector<double> lows_;
  WindowList envelope_;
  std::uint64_t dropped_ = 0;
};

}  // namespace geodrome::merged_windows
