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

/// The windows [0, low_end) of a carried list begin at the start of the new edge, those from `high_begin` on end at
/// its end, wherever their lines go.
struct Clip {
  int low_end, high_begin;
};

/// What a cut leaves to do: some neighbours still overlap if `unsure`, some windows are empty if `empty`.
struct Trimmed {
  bool unsure, empty;
  bool is_whole() const { return !unsure && !empty; }
};

/// The loops over windows that cost the time, for one width of SIMD registers. Every level does the same IEEE
/// operations on every window, so all give the same bytes. Up to 2 x `most_lanes` windows beyond the last are read,
/// whatever they hold; in what is written, up to `most_lanes` - 1 have any value afterwards.
struct Lanes {
  /// The first `count` windows of `in` as seen from the new edge.
  void (*carry)(const WindowArrays& in, std::size_t count, const Turn& turn, const Clip& clip, const WindowArrays& out);

  /// Cuts neighbours that overlap, of `count` >= 1 windows, by the lemma of ordered neighbours (ordered_pair.hpp): at
  /// the place where they are equally far if the formula for it passes its check; else the one that is nearer at the
  /// far end of the overlap keeps all of it. Other pairs stay as they are.
  Trimmed (*cut)(const WindowArrays& windows, std::size_t count);

  /// Where a list is parted by the point (x, y), y > 0.
  Parting (*part)(const WindowArrays& windows, std::size_t count, double x, double y);
};

enum class Simd { baseline, avx2, avx512 };

/// The widest level that the processor has.
Simd best_simd();
bool has_simd(Simd level);
/// Precondition: the processor has the level.
const Lanes& lanes(Simd level);

}  // namespace geodrome::chen_han
