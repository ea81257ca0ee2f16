// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/trimming.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/lower_envelope.hpp"
#include "plugins/common/exact/ordered_row.hpp"

namespace geodrome::chen_han {
namespace {

/// Windows as a row, and as a list of pieces.
struct WindowRow {
  const WindowArrays& windows;
  std::size_t count;

  std::size_t size() const { return count; }
  double& low(std::size_t i) const { return windows.low[i]; }
  double& high(std::size_t i) const { return windows.high[i]; }
  Window image(std::size_t i) const { return windows.get(i); }
  void move(std::size_t from, std::size_t to) const { windows.set(to, windows.get(from)); }
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
    const PairOrder order = settle_in_row(WindowRow{w, count}, i, i + 1);
    if (order == PairOrder::drop_left) w.high[i] = w.low[i];
    if (order == PairOrder::drop_right) w.low[i + 1] = w.high[i + 1];
    tangled = tangled || order == PairOrder::tangled;
  }
  for (std::size_t i = 0; i < count; ++i) some_empty |= w.empty(i);
  return tangled || some_empty ? repair(w, count, breaks) : count;
}

std::size_t Trimming::repair(const WindowArrays& w, std::size_t count, std::vector<std::uint32_t>& breaks) {
  const std::size_t end = trim_row(WindowRow{w, count}, count, breaks);
  dropped_ += count - end;
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
  const std::size_t end = list.size();
  const Seam seam = trim_seam(WindowRow{w, end}, middle, end);
  if (!seam.in_order) {
    list.resize(seam.left);
    return false;
  }
  dropped_ += (middle - seam.left) + (seam.right - middle);
  if (seam.right > seam.left) copy_windows(w.without(seam.right), end - seam.right, w.without(seam.left));
  list.resize(seam.left + end - seam.right);
  return true;
}

}  // namespace geodrome::chen_han
