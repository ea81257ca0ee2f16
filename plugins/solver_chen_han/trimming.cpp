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
  WindowArrays windows;
  std::size_t count;

  std::size_t size() const { return count; }
  double& low(std::size_t i) const { return windows.low()[i]; }
  double& high(std::size_t i) const { return windows.high()[i]; }
  Window image(std::size_t i) const { return windows.get(i); }
  void move(std::size_t from, std::size_t to) const { windows.set(to, windows.get(from)); }
};

}  // namespace

std::size_t Trimming::finish(const WindowArrays& w, std::size_t count, std::vector<std::uint32_t>& breaks) {
  const std::size_t end = trim_row(WindowRow{w, count}, count, breaks);
  dropped_ += count - end;
  return end;
}

void Trimming::merge(WindowList& list, const Span& other) {
  const std::size_t size = list.size();
  merged_.clear();
  lower_envelope(WindowRow{list.arrays(), size}, WindowRow{other.windows, other.count},
                 [this](const WindowRow& row, std::size_t i, double low, double high) {
                   Window piece = row.image(i);
                   piece.low = low, piece.high = high;
                   merged_.push(piece);
                 });
  dropped_ += size + other.count - std::min(size + other.count, merged_.size());  // pieces hide some
  std::swap(list, merged_);
}

}  // namespace geodrome::chen_han
