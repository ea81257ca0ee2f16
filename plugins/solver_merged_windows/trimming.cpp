// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/trimming.hpp"

#include <algorithm>
#include <utility>

#include "plugins/common/exact/lower_envelope.hpp"
#include "plugins/common/exact/ordered_row.hpp"

namespace geodrome::merged_windows {
namespace {

/// Windows as a row that is trimmed.
struct Row {
  Window* windows;

  double& low(std::size_t i) const { return windows[i].low; }
  double& high(std::size_t i) const { return windows[i].high; }
  const Window& image(std::size_t i) const { return windows[i]; }
  void move(std::size_t from, std::size_t to) const { windows[to] = windows[from]; }
};

/// Windows as a list of pieces.
struct Pieces {
  std::span<const Window> windows;

  std::size_t size() const { return windows.size(); }
  double low(std::size_t i) const { return windows[i].low; }
  double high(std::size_t i) const { return windows[i].high; }
  const Window& image(std::size_t i) const { return windows[i]; }
};

}  // namespace

Remains Trimming::settle(Window& left, Window& right) {
  if (left.empty() || right.empty()) {
    dropped_ += left.empty() + right.empty();
    return !left.empty() ? Remains::left : right.empty() ? Remains::none : Remains::right;
  }
  Interval l{left.low, left.high}, r{right.low, right.high};
  const PairOrder order = settle_pair(left, l, right, r);
  if (order == PairOrder::tangled) return Remains::unsettled;
  left.high = l.high, right.low = r.low;
  const bool no_left = order == PairOrder::drop_left || left.empty();
  const bool no_right = order == PairOrder::drop_right || right.empty();
  dropped_ += no_left || no_right;
  if (no_right) return Remains::left;
  return no_left ? Remains::right : Remains::both;
}

void Trimming::trim(WindowList& list) {
  if (list.size() == 1 && !list[0].empty()) return breaks_.clear();
  const std::size_t end = trim_row(Row{list.data()}, list.size(), breaks_);
  dropped_ += list.size() - end;
  list.resize(end);
}

bool Trimming::join(WindowList& list, std::size_t& middle) {
  lows_.clear();
  for (std::size_t i = middle; i < list.size(); ++i) lows_.push_back(list[i].low);
  const Seam seam = trim_seam(Row{list.data()}, middle, list.size());
  if (!seam.in_order)
    for (std::size_t i = middle; i < list.size(); ++i) list[i].low = lows_[i - middle];
  const std::size_t right = seam.in_order ? seam.right : middle;
  if (right > seam.left) {
    dropped_ += right - seam.left;
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(seam.left),
               list.begin() + static_cast<std::ptrdiff_t>(right));
    middle = seam.left;
  }
  return seam.in_order;
}

void Trimming::merge(WindowList& list, std::span<const Window> other) {
  envelope_.clear();
  lower_envelope(Pieces{list}, Pieces{other}, [this](const Pieces& of, std::size_t i, double low, double high) {
    envelope_.push_back(of.image(i));
    envelope_.back().low = low, envelope_.back().high = high;
  });
  const std::size_t before = list.size() + other.size();
  dropped_ += before - std::min(before, envelope_.size());  // pieces hide some
  std::swap(list, envelope_);
}

}  // namespace geodrome::merged_windows
