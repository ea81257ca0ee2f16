// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/trimming.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plugins/common/exact/bisector.hpp"

namespace geodrome::chen_han {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// What becomes of an ordered pair.
enum class Pair { in_order, cut, drop_left, drop_right, tangled };

/// Brings an ordered pair of windows into order by the lemma, with nothing else known. Where the two are equally far up
/// to rounding, as along the line from one through the other, no window is cut for the sake of one inside it: what
/// rounding would then take from it nothing else would cover.
Pair settle(const WindowArrays& w, std::size_t left, const WindowArrays& v, std::size_t right) {
  if (w.empty(left)) return Pair::drop_left;
  if (v.empty(right)) return Pair::drop_right;
  if (w.high[left] <= v.low[right]) return Pair::in_order;
  const double low = std::max(w.low[left], v.low[right]), high = std::min(w.high[left], v.high[right]);
  if (!(low < high)) {
    if (nearer(w.at(left, w.low[left]), v.at(right, w.low[left]))) return Pair::drop_right;
    if (nearer(v.at(right, v.high[right]), w.at(left, v.high[right]))) return Pair::drop_left;
    return Pair::tangled;
  }
  const bool left_keeps_all = !nearer(v.at(right, high), w.at(left, high));
  const bool right_keeps_all = !nearer(w.at(left, low), v.at(right, low));
  const bool left_is_inside = v.low[right] < low;
  // As far everywhere, but the right one on the left: the lemma needs one to be nearer.
  if (left_keeps_all && right_keeps_all && left_is_inside && high < w.high[left]) return Pair::tangled;
  if (left_keeps_all && !(right_keeps_all && left_is_inside))
    v.low[right] = high;
  else if (right_keeps_all)
    w.high[left] = low;
  else
    w.high[left] = v.low[right] = equal_place(w.get(left), v.get(right), low, high);
  return Pair::cut;
}

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
    const Pair pair = settle(w, i, w, i + 1);
    if (pair == Pair::drop_left) w.high[i] = w.low[i];
    if (pair == Pair::drop_right) w.low[i + 1] = w.high[i + 1];
    tangled = tangled || pair == Pair::tangled;
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
      const Pair pair = settle(w, end - 1, w, i);
      if (pair == Pair::drop_right || w.empty(i)) return false;
      if (pair == Pair::in_order) break;
      if (pair == Pair::tangled) {
        start = end;
        breaks.push_back(static_cast<std::uint32_t>(end));
        break;
      }
      if (pair == Pair::cut && !w.empty(end - 1)) break;
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

namespace {

/// The lower envelope as it grows from left to right; pieces of one window that touch are one.
class Envelope {
 public:
  explicit Envelope(WindowList& out) : out_(out) { out_.clear(); }

  void add(const Window& window, std::size_t name, double low, double high) {
    if (!(low < high)) return;
    if (!out_.empty() && last_ == name && out_.arrays().high[out_.size() - 1] == low) {
      out_.arrays().high[out_.size() - 1] = high;
      return;
    }
    Window piece = window;
    piece.low = low, piece.high = high;
    out_.push(piece);
    last_ = name;
  }

  /// The nearer of two windows, everywhere in [low, high]. |a x| - |b x| has one stationary point along a line, where
  /// that of the images meets it; before and behind it the two change places at most once.
  void add_nearer(const Window& a, std::size_t name_a, const Window& b, std::size_t name_b, double low, double high) {
    const double turn = b.x + (a.x - b.x) * (b.y / (b.y - a.y));
    if (low < turn && turn < high) {
      add_monotone(a, name_a, b, name_b, low, turn);
      low = turn;
    }
    add_monotone(a, name_a, b, name_b, low, high);
  }

 private:
  void add_monotone(const Window& a, std::size_t name_a, const Window& b, std::size_t name_b, double low, double high) {
    const double at_low = a.at(low) - b.at(low), at_high = a.at(high) - b.at(high);
    const bool a_first = at_low < 0 || (at_low == 0 && at_high <= 0);
    const bool a_last = at_high < 0 || (at_high == 0 && at_low <= 0);
    const double x = a_first == a_last ? high : equal_place(a, b, low, high);
    add(a_first ? a : b, a_first ? name_a : name_b, low, x);
    add(a_last ? a : b, a_last ? name_a : name_b, x, high);
  }

  WindowList& out_;
  std::size_t last_ = 0;
};

}  // namespace

void Trimming::merge(WindowList& list, const WindowArrays& other, std::size_t count) {
  Envelope envelope(merged_);
  const WindowArrays& w = list.arrays();
  const std::size_t size = list.size();
  double x = -none;
  for (std::size_t i = 0, j = 0; i < size || j < count;) {
    const double low_i = i < size ? std::max(w.low[i], x) : none, high_i = i < size ? w.high[i] : none;
    const double low_j = j < count ? std::max(other.low[j], x) : none, high_j = j < count ? other.high[j] : none;
    if (i < size && !(low_i < high_i)) {
      ++i;
    } else if (j < count && !(low_j < high_j)) {
      ++j;
    } else if (low_i < low_j) {
      x = std::min(high_i, low_j);
      envelope.add(w.get(i), i, low_i, x);
    } else if (low_j < low_i) {
      x = std::min(high_j, low_i);
      envelope.add(other.get(j), size + j, low_j, x);
    } else {
      x = std::min(high_i, high_j);
      envelope.add_nearer(w.get(i), i, other.get(j), size + j, low_i, x);
    }
  }
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
      case Pair::in_order:
        break;
      case Pair::cut:
        if (w.empty(left - 1)) {
          --left;
          continue;
        }
        if (w.empty(next)) {
          ++next;
          continue;
        }
        break;
      case Pair::drop_left:
        --left;
        continue;
      case Pair::drop_right:
        ++next;
        continue;
      case Pair::tangled:
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
