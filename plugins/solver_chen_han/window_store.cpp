// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/window_store.hpp"

#include <cstring>
#include <new>

namespace geodrome::chen_han {

/// A block too large for a page gets one of its own. Lanes read beyond the last window of a page, into the slack.
Block& WindowStore::cut_from_page(std::size_t kind) {
  constexpr std::size_t slack = 2 * most_lanes * sizeof(double) / sizeof(Block);
  const std::size_t capacity = capacity_of(kind);
  const std::size_t size = 1 + capacity * WindowArrays::doubles_per_window * sizeof(double) / sizeof(Block);
  if (page_used_ + size > page_units) {
    const std::size_t page = std::max(size, page_units) + slack;
    if (pages_.size() >= no_index / page_units) throw std::bad_alloc();
    pages_.emplace_back(static_cast<Block*>(::operator new (page * sizeof(Block), std::align_val_t{alignof(Block)})));
    std::memset(static_cast<void*>(pages_.back().get()), 0, page * sizeof(Block));
    page_used_ = 0, units_ += page;
  }
  const auto number = static_cast<Index>((pages_.size() - 1) * page_units + page_used_);
  page_used_ += size;
  Block& block = at(number);
  block.number = number, block.kind = static_cast<std::uint8_t>(kind);
  block.capacity = static_cast<std::uint32_t>(capacity);
  return block;
}

}  // namespace geodrome::chen_han
