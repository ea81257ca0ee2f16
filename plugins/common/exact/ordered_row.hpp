// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/ordered_pair.hpp"

namespace geodrome {

/// Windows of one half-edge side by side in memory, ordered: their lines enter the face below in the order in which
/// they stand. A `Row` does not own them and has
///
/// - `image(i)`: x, y, sigma, `at(x)`, `to(x, y)`; `low(i)`, `high(i)`: the interval, as references to doubles;
/// - `move(from, to)`: puts a window in the place of another.
///
/// The functions below cut intervals by the lemma of ordered neighbours alone (ordered_pair.hpp), until the windows
/// that remain are disjoint and ascend.

template <class Row>
bool is_empty(const Row& row, std::size_t i) {
  return !(row.low(i) < row.high(i));
}

/// Settles window `left` against window `right`, which enters to the right of it.
template <class Row>
PairOrder settle_in_row(const Row& row, std::size_t left, std::size_t right) {
  Interval l{row.low(left), row.high(left)}, r{row.low(right), row.high(right)};
  const PairOrder order = settle_pair(row.image(left), l, row.image(right), r);
  row.high(left) = l.high, row.low(right) = r.low;
  return order;
}

/// Trims `count` ordered windows that may overlap, and drops what is left empty; returns how many remain, in the first
/// places. `breaks` gets the positions before which a pair could not be put in order: the row is ordered between them
/// only. Walks along the row with a stack: a window that is used up goes, and its neighbours meet. Their intervals
/// still hold the place where they do, since each was cut where the lost one was not better. O(count).
template <class Row>
std::size_t trim_row(const Row& row, std::size_t count, std::vector<std::uint32_t>& breaks) {
  breaks.clear();
  std::size_t end = 0;    // windows [0, end) are in order
  std::size_t start = 0;  // of the present ordered run
  const auto take = [&](std::size_t i) {
    if (is_empty(row, i)) return false;
    while (end > start && row.high(end - 1) > row.low(i)) {
      const PairOrder order = settle_in_row(row, end - 1, i);
      if (order == PairOrder::drop_right || is_empty(row, i)) return false;
      if (order == PairOrder::apart) break;
      if (order == PairOrder::tangled) {
        start = end;
        breaks.push_back(static_cast<std::uint32_t>(end));
        break;
      }
      if (order == PairOrder::cut && !is_empty(row, end - 1)) break;
      --end;
    }
    return true;
  };
  for (std::size_t i = 0; i < count; ++i)
    if (take(i)) {
      if (end != i) row.move(i, end);
      ++end;
    }
  // A run may have shrunk to nothing behind a break.
  while (!breaks.empty() && breaks.back() >= end) breaks.pop_back();
  return end;
}

/// What remains of two rows after `trim_seam`: [0, left) and [right, end).
struct Seam {
  std::size_t left, right;
  bool in_order;
};

/// Trims at the seam of two ordered rows of disjoint windows, [0, middle) and [middle, end), the second of which enters
/// to the right of the first. Not `in_order` if they cannot be put in order; what the first row lost is not needed
/// then, and the second is to be used as it was before.
template <class Row>
Seam trim_seam(const Row& row, std::size_t middle, std::size_t end) {
  std::size_t left = middle, right = middle;
  // The window of the other side that has `place` inside, if it is at least as near there as window `of`.
  const auto beaten = [&](std::size_t of, double place, std::size_t first, std::size_t last) {
    std::size_t over = first;
    for (std::size_t count = last - first; count > 0;) {
      const std::size_t half = count / 2;
      if (row.low(over + half) <= place)
        over += half + 1, count -= half + 1;
      else
        count = half;
    }
    return over > first && row.high(over - 1) >= place &&
           nearer(row.image(over - 1).at(place), row.image(of).at(place));
  };
  while (left > 0 && right < end) {
    switch (settle_in_row(row, left - 1, right)) {
      case PairOrder::apart:
        return {left, right, true};
      case PairOrder::cut:
        if (is_empty(row, left - 1))
          --left;
        else if (is_empty(row, right))
          ++right;
        else
          return {left, right, true};
        break;
      case PairOrder::drop_left:
        --left;
        break;
      case PairOrder::drop_right:
        ++right;
        break;
      case PairOrder::tangled:
        if (beaten(left - 1, row.low(left - 1), right, end))
          --left;
        else if (beaten(right, row.high(right), 0, left))
          ++right;
        else
          return {left, right, false};
        break;
    }
  }
  return {left, right, true};
}

}  // namespace geodrome
