// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "plugins/common/exact/turn.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// Of a list: the windows [0, left_end) have lines to the left of a point, [right_begin, count) to its right. Only if
/// `in_order`; lines of an ordered list may cross beyond their half-edge.
struct Parting {
  std::size_t right_begin, left_end;
  bool in_order;
};

/// The loops over windows that cost the time, for one width of SIMD registers. Every level does the same IEEE
/// operations on every window, so all give the same bytes. Arrays must be padded: up to `padding` windows beyond the
/// last are read and, in what is written, have any value afterwards.
struct Lanes {
  /// The first `count` windows of `in` as seen from the new edge.
  void (*carry)(const WindowArrays& in, std::size_t count, const Turn& turn, const WindowArrays& out);

  /// For windows i and i + 1 that overlap, where to cut: cut[i] is the place at which they are equally far, or the end
  /// of the one that wins all of the overlap if it ends it. NaN where they do not overlap, or where the formula did not
  /// pass its check; true if it did not somewhere. Reads `count` windows, count >= 1, writes count - 1 cuts.
  bool (*cut)(const WindowArrays& windows, std::size_t count, double* cut);

  /// Where a list is parted by the point (x, y), y > 0.
  Parting (*part)(const WindowArrays& windows, std::size_t count, double x, double y);
};

enum class Simd { baseline, avx2 };

/// The widest level that the processor has.
Simd best_simd();
bool has_simd(Simd level);
/// Precondition: the processor has the level.
const Lanes& lanes(Simd level);

}  // namespace geodrome::chen_han
