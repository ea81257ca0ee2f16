// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/mesh/apex.hpp"
#include "plugins/solver_chen_han/lanes.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// Whether window i has lines to the left or right of the apex.
inline bool has_left(const Apex& apex, const WindowArrays& w, std::size_t i) {
  return side_of_line(w.x()[i], w.y()[i], w.low()[i], apex.x, apex.y) < 0;
}
inline bool has_right(const Apex& apex, const WindowArrays& w, std::size_t i) {
  return side_of_line(w.x()[i], w.y()[i], w.high()[i], apex.x, apex.y) > 0;
}

/// How an ordered list meets the apex: windows [0, left_end) have lines to its left, [right_begin, end) to its right;
/// what is in both has lines to it. `best` of those is nearest to it; from [first_best, last_best), which are as near
/// up to rounding, lines go on to both sides, from the others only to their own: one angle, one split.
struct Split {
  std::size_t right_begin, left_end, best, first_best, last_best;

  bool covered() const { return right_begin < left_end; }
  /// The windows [0, last_left) go on to the left, [first_right, end) to the right.
  std::size_t last_left() const { return covered() ? last_best : left_end; }
  std::size_t first_right() const { return covered() ? first_best : right_begin; }
};

/// The split of a list in order.
inline Split split_at(const Apex& apex, const WindowArrays& w, const Parting& parting) {
  Split split{parting.right_begin, parting.left_end, parting.right_begin, 0, 0};
  const auto distance = [&](std::size_t i) { return w.to(i, apex.x, apex.y); };
  for (std::size_t i = split.right_begin + 1; i < split.left_end; ++i)
    if (distance(i) < distance(split.best)) split.best = i;
  split.first_best = split.best, split.last_best = split.best + 1;
  if (split.left_end - split.right_begin > 1 && split.covered()) {
    const double most = distance(split.best) * (1 + equal_share);
    while (split.first_best > split.right_begin && distance(split.first_best - 1) <= most) --split.first_best;
    while (split.last_best < split.left_end && distance(split.last_best) <= most) ++split.last_best;
  }
  return split;
}

}  // namespace geodrome::chen_han
