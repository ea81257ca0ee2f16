// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/trimming.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/lower_envelope.hpp"
#include "plugins/common/exact/ordered_pair.hpp"

namespace geodrome::chen_han {
namespace {

/// Settles window `left` of one list and window `right` of another, in place.
PairOrder settle(const WindowArrays& w, std::size_t left, const WindowArrays& v, std::size_t right) {
  Interval l{w.low[left], w.high[left]}, r{v.low[right], v.high[right]};
  const PairOrder order = settle_pair(w.get(left), l, v.get(right), r);
  w.high[left] = l.high, v.low[right] = r.low;
  return order;
}

/// Windows as a list of pieces.
struct WindowRow {
  const WindowArrays& windows;
  std::size_t count;

  std::size_t size() const { return count; }
  double low(std::size_t i) const { return windows.low[i]; }
  double high(std::size_t i) const { return windows.high[i]; }
  Window image(std::size_t i) const { return windows.get(i); }
};

}  // namespace

std::size_t Trimming::trim(const WindowArrays& w, std::size_t count, std::vector<std::uint32_t>& breaks) {
  breaks.clear();
  if (count == 1) {
    dropped_ += w.empty(0);
    return w.empty(0) ? 0 : 1;
  }
  if (cuts_.size() < count + most_lanes) cuts_.resize(2 * (count + most_lanes));
  const bool unsure = lanes_->cut(w, count, cuts_.data());
  for (std::size_t i = 0; i + 1 < count; ++i) {  // where there is no cut, neither is true
    w.high[i] = cuts_[i] < w.high[i] ? cuts_[i] : w.high[i];
    w.low[i + 1] = cuts_[i] > w.low[i + 1] ? cuts_[i] : w.low[i + 1];
  }
  bool tangled = false, some_empty = false;
  for (std::size_t i = 0; unsure && i + 1 < count; ++i) {
    if (!std::isnan(cuts_[i])) continue;
    const PairOrder order = settle(w, i, w, i + 1);
    if (order == PairOrder::drop_left) w.high[i] = w.low[i];
    if (order == PairOrder::drop_right) w.low[i + 1] = w.high[i + 1];
    tangled = tangled || order == PairOrder::tangled;
  }
  for (std::size_t i = 0; i < count; ++i) some_empty |= w.empty(i);
  return tangled || some_empty ? repair(w, count, breaks) : count;
}

/// Walks along the list with a stack: a window that is used up goes, and its
/// neighbours meet. Their intervals still hold the place where they do, since each was cut where the lost one was not
/// better.
std::size_t Trimming::repair(const WindowArrays& w, std::size_t count, std::vector<std::uint32_t>& breaks) {
  std::size_t end = 0;    // windows [0, end) are in order
  std::size_t start = 0;  // of the present ordered run
  const auto take = [&](std::size_t i) {
    if (w.empty(i)) return false;
    while (end > start) {
      const PairOrder order = settle(w, end - 1, w, i);
      if (order == PairOrder::drop_right || w.empty(i)) return false;
      if (order == PairOrder::apart) break;
      if (order == PairOrder::tangled) {
        start = end;
        breaks.push_back(static_cast<std::uint32_t>(end));
        break;
      }
      if (order == PairOrder::cut && !w.empty(end - 1)) break;
      --end;
    }
    return true;
  };
  for (std::size_t i = 0; i < count; ++i)
    if (take(i)) {
      if (end != i) w.set(end, w.get(i));
      ++end;
    }
  dropped_ += count - end;
  // A run may have shrunk to nothing behind a break.
  while (!breaks.empty() && breaks.back() >= end) breaks.pop_back();
  return end;
}

void Trimming::merge(WindowList& list, const WindowArrays& other, std::size_t count) {
  const std::size_t size = list.size();
  merged_.clear();
  lower_envelope(WindowRow{list.arrays(), size}, WindowRow{other, count},
                 [this](const WindowRow& row, std::size_t i, double low, double high) {
                   Window piece = row.image(i);
                   piece.low = low, piece.high = high;
                   merged_.push(piece);
                 });
  dropped_ += size + count - std::min(size + count, merged_.size());  // pieces hide some
  std::swap(list, merged_);
}

bool Trimming::append(WindowList& list, const WindowArrays& right, std::size_t count) {
  const std::size_t middle = list.size();
  list.append(right, count);
  const WindowArrays& w = list.arrays();
  std::size_t left = middle, next = middle;  // windows [0, left) and [next, end) remain
  const std::size_t end = list.size();
  // The window of the other side that has `place` inside, if it is at least as near there as window `of`.
  const auto beaten = [&](std::size_t of, double place, std::size_t first, std::size_t last) {
    const auto over = std::upper_bound(w.low + first, w.low + last, place) - w.low;
    const auto at = static_cast<std::size_t>(over);
    return at > first && w.high[at - 1] >= place && nearer(w.at(at - 1, place), w.at(of, place));
  };
  while (left > 0 && next < end) {
    switch (settle(w, left - 1, w, next)) {
      case PairOrder::apart:
        break;
      case PairOrder::cut:
        if (w.empty(left - 1)) {
          --left;
          continue;
        }
        if (w.empty(next)) {
          ++next;
          continue;
        }
        break;
      case PairOrder::drop_left:
        --left;
        continue;
      case PairOrder::drop_right:
        ++next;
        continue;
      case PairOrder::tangled:
        if (beaten(left - 1, w.low[left - 1], next, end)) {
          --left;
          continue;
        }
        if (beaten(next, w.high[next], 0, left)) {
          ++next;
          continue;
        }
        list.resize(left);
        return false;
    }
    break;
  }
  dropped_ += (middle - left) + (next - middle);
  if (next > left) copy_windows(w.without(next), end - next, w.without(left));
  list.resize(left + end - next);
  return true;
}

}  // namespace geodrome::chen_han
