// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/fan_windows.hpp"

#include <utility>

namespace geodrome::chen_han {

const WindowList& FanWindows::claim(Index edge, const WindowArrays& windows, std::size_t count) {
  list_pieces(windows, count);
  envelope_.claim(edge, pieces_);
  list_parts(windows);
  return parts_;
}

void FanWindows::keep_nearest(Index half_edge, WindowList& list) {
  list_pieces(list.arrays(), list.size());
  envelope_.keep_nearest(half_edge, pieces_);
  list_parts(list.arrays());
  std::swap(list, parts_);
}

void FanWindows::list_pieces(const WindowArrays& w, std::size_t count) {
  pieces_.clear();
  for (std::size_t i = 0; i < count; ++i)
    pieces_.push_back({w.x()[i], w.y()[i], w.sigma()[i], w.low()[i], w.high()[i], static_cast<std::uint32_t>(i)});
}

void FanWindows::list_parts(const WindowArrays& windows) {
  parts_.clear();
  for (const EdgePiece& piece : pieces_) {
    Window part = windows.get(piece.number);
    part.low = piece.low, part.high = piece.high;
    parts_.push(part);
  }
}

}  // namespace geodrome::chen_han
