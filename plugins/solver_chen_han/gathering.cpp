// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/gathering.hpp"

#include <algorithm>

namespace geodrome::chen_han {

Gathering::Gathered Gathering::gather_several(Index half_edge, Block& first) {
  loose_.clear(), rest_.clear();
  Index depth = first.depth;
  Span list = in_order(first, depth);
  if (list.count > 0) trim(list, rest_);
  if (!loose_.empty() || !rest_.empty() || surface_.branches(half_edge)) list = merged(half_edge, list);
  return {list, depth};
}

void Gathering::part_at_breaks(Span& list, std::vector<Span>& rest) {
  for (; !breaks_.empty(); breaks_.pop_back()) {
    const std::size_t first = breaks_.back();
    rest.push_back({list.windows.without(first), list.count - first});
    list.count = first;
  }
}

/// Joins several blocks: one of each entry in their order; the others are loose.
Span Gathering::in_order(Block& first, Index& depth) {
  std::array<Block*, 3> ordered{};
  for (Block* b = &first; b; b = following(*b)) {
    depth = std::min(depth, b->depth);
    if (b->entry == Entry::loose || ordered[static_cast<std::size_t>(b->entry)])
      loose_.push_back(b);
    else
      ordered[static_cast<std::size_t>(b->entry)] = b;
  }
  return joined(ordered);
}

/// Joins blocks in the memory of the first if they fit.
Span Gathering::joined(const std::array<Block*, 3>& ordered) {
  Block* base = nullptr;
  std::size_t room = 0;
  for (Block* b : ordered) {
    if (!b) continue;
    if (!base) base = b;
    room += room_for_copy(b->count);
  }
  if (!base) return {joined_.arrays(), 0};
  Span list = base->span();
  if (room > base->capacity) joined_.assign(list, room), list = joined_.span();
  for (Block* b : ordered) {
    if (!b || b == base) continue;
    copy_windows(b->windows(), b->count, list.windows.without(list.count));
    list.count += b->count;
  }
  return list;
}

/// Merges a list with all that is in no order with it. Where more than two faces meet, something nearer may have come
/// since.
Span Gathering::merged(Index half_edge, const Span& list) {
  for (Block* b : loose_) {
    Span own = b->span();
    trim(own, rest_);
    rest_.push_back(own);
  }
  merged_.assign(list);
  for (const Span& rest : rest_) trimming_.merge(merged_, rest);
  if (surface_.branches(half_edge)) fans_.keep_nearest(half_edge, merged_);
  return merged_.span();
}

}  // namespace geodrome::chen_han
