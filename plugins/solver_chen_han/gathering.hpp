// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_chen_han/fan_windows.hpp"
#include "plugins/solver_chen_han/trimming.hpp"
#include "plugins/solver_chen_han/window_store.hpp"

namespace geodrome::chen_han {

/// Makes one list of what waits at a half-edge: its windows disjoint and ascending.
class Gathering {
 public:
  Gathering(const PackedMesh& surface, WindowStore& store, FanWindows& fans, Trimming& trimming)
      : surface_(surface), store_(store), fans_(fans), trimming_(trimming) {}

  struct Gathered {
    Span list;    ///< in the memory of the blocks or of this; valid until the blocks are released or the next call
    Index depth;  ///< the least of the blocks
  };
  /// All of the blocks at a half-edge, of which `first` is the first.
  Gathered gather(Index half_edge, Block& first) {
    if (first.next != no_index || surface_.branches(half_edge)) return gather_several(half_edge, first);
    Span list = first.span();
    rest_.clear();
    trim(list, rest_);
    if (!rest_.empty()) loose_.clear(), list = merged(half_edge, list);
    return {list, first.depth};
  }
  /// Gives the blocks back.
  void release(Block& first) {
    for (Block* b = &first; b;) {
      Block* next = following(*b);
      store_.release(*b);
      b = next;
    }
  }

  /// Trims a list in order. Where it has breaks, what is behind them goes to `rest`.
  void trim(Span& list, std::vector<Span>& rest) {
    list.count = trimming_.trim(list.windows, list.count, breaks_);
    if (!breaks_.empty()) part_at_breaks(list, rest);
  }

  std::size_t bytes() const { return joined_.bytes() + merged_.bytes(); }

 private:
  Block* following(const Block& block) { return block.next == no_index ? nullptr : &store_[block.next]; }
  void part_at_breaks(Span& list, std::vector<Span>& rest);
  Gathered gather_several(Index half_edge, Block& first);
  Span in_order(Block& first, Index& depth);
  Span joined(const std::array<Block*, 3>& ordered);
  Span merged(Index half_edge, const Span& list);

  const PackedMesh& surface_;
  WindowStore& store_;
  FanWindows& fans_;
  Trimming& trimming_;
  std::vector<Block*> loose_;  ///< in no order with the others
  std::vector<Span> rest_;
  std::vector<std::uint32_t> breaks_;
  WindowList joined_, merged_;
};

}  // namespace geodrome::chen_han
