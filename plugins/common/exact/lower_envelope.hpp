// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <utility>

#include "geodrome/geometry.hpp"
#include "plugins/common/exact/image_pair.hpp"

namespace geodrome {

/// A list of images (members `x`, `y`, `sigma`, `at(x)`), each with a piece of a half-edge; the pieces are disjoint and
/// ascend. A piece may be empty.
template <class List>
concept PieceList = requires(const List& list, std::size_t i) {
  { list.size() } -> std::convertible_to<std::size_t>;
  { list.low(i) } -> std::convertible_to<double>;
  { list.high(i) } -> std::convertible_to<double>;
  { list.image(i).at(list.low(i)) } -> std::convertible_to<double>;
};

/// How far two distances may differ and still tie: by `share` of (the larger one + `span`).
struct Slack {
  double share = 0, span = 0;
};

/// Builds the lower envelope of two lists from left to right. Pieces of one entry that touch are emitted as one.
template <PieceList List, class Emit>
class LowerEnvelope {
 public:
  LowerEnvelope(const List& a, const List& b, Emit& emit, const Slack& slack)
      : a_(a), b_(b), emit_(emit), slack_(slack) {}

  void sweep() {
    double x = -infinity;
    for (std::size_t i = 0, j = 0; i < a_.size() || j < b_.size();) {
      const bool has_a = i < a_.size(), has_b = j < b_.size();
      const double low_a = has_a ? std::max<double>(a_.low(i), x) : infinity, high_a = has_a ? a_.high(i) : infinity;
      const double low_b = has_b ? std::max<double>(b_.low(j), x) : infinity, high_b = has_b ? b_.high(j) : infinity;
      if (has_a && !(low_a < high_a)) {
        ++i;
      } else if (has_b && !(low_b < high_b)) {
        ++j;
      } else if (low_a < low_b) {
        x = std::min(high_a, low_b);
        add({&a_, i}, low_a, x);
      } else if (low_b < low_a) {
        x = std::min(high_b, low_a);
        add({&b_, j}, low_b, x);
      } else {
        x = std::min(high_a, high_b);
        add_nearer(i, j, low_a, x);
      }
    }
    flush();
  }

 private:
  struct Entry {
    const List* list = nullptr;
    std::size_t number = 0;
    bool operator==(const Entry&) const = default;
  };

  void add(Entry entry, double low, double high) {
    if (!(low < high)) return;
    if (entry == last_ && low == last_high_) {
      last_high_ = high;
      return;
    }
    flush();
    last_ = entry, last_low_ = low, last_high_ = high;
  }
  void flush() {
    if (last_.list) emit_(*last_.list, last_.number, last_low_, last_high_);
  }

  /// Adds the nearer of entries i and j, everywhere in [low, high]. |a x| - |b x| has one stationary point along the
  /// half-edge, where the line through the images meets it; on either side of that the two change places at most once.
  void add_nearer(std::size_t i, std::size_t j, double low, double high) {
    const auto& a = a_.image(i);
    const auto& b = b_.image(j);
    const double turn = b.x + (a.x - b.x) * (b.y / (b.y - a.y));
    if (low < turn && turn < high) {
      add_monotone(a, {&a_, i}, b, {&b_, j}, low, turn);
      low = turn;
    }
    add_monotone(a, {&a_, i}, b, {&b_, j}, low, high);
  }

  template <class Image>
  void add_monotone(const Image& a, Entry entry_a, const Image& b, Entry entry_b, double low, double high) {
    const double at_low = gap(a.at(low), b.at(low)), at_high = gap(a.at(high), b.at(high));
    const bool a_first = at_low < 0 || (at_low == 0 && at_high <= 0);
    const bool a_last = at_high < 0 || (at_high == 0 && at_low <= 0);
    const double x = a_first == a_last ? high : equal_place(a, b, low, high);
    add(a_first ? entry_a : entry_b, low, x);
    add(a_last ? entry_a : entry_b, x, high);
  }

  double gap(double a, double b) const {
    return std::abs(a - b) <= slack_.share * (std::max(a, b) + slack_.span) ? 0 : a - b;
  }

  const List &a_, &b_;
  Emit& emit_;
  Slack slack_;
  Entry last_;
  double last_low_ = 0, last_high_ = 0;
};

/// Calls `emit(list, i, low, high)` for the pieces [low, high] of the lower envelope of two lists, from left to right:
/// in each of them entry i of `list` (one of the two) is nearest; that of `a` if two tie up to `slack`. Nothing is
/// known about the order in which rays enter, so an entry may come out in several pieces. `a` and `b` are two objects.
/// O(n + m).
template <PieceList List, class Emit>
void lower_envelope(const List& a, const List& b, Emit&& emit, const Slack& slack = {}) {
  LowerEnvelope<List, Emit>(a, b, emit, slack).sweep();
}

}  // namespace geodrome
