// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "plugins/common/exact/entry.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// Windows that wait at a half-edge, in the order in which they enter its face. They lie in memory right behind it.
struct alignas(32) Block {
  Index number;  ///< in the store
  Index next;    ///< block at the same half-edge, no_index after the last
  Index depth;   ///< faces crossed since the pseudo-source, at least
  std::uint32_t count, capacity;
  std::uint8_t kind;  ///< the store's own
  Entry entry;        ///< of all its windows
  double near;        ///< about the least distance, by which it queues

  WindowArrays windows() { return {reinterpret_cast<double*>(this + 1), capacity}; }
  Span span() { return {windows(), count}; }
};

/// The memory of waiting windows: blocks cut from pages and used again by size, so that it holds the wavefront and no
/// more. A block stays where it is until it is released. Nothing is given back before the end.
class WindowStore {
 public:
  Block& operator[](Index block) { return at(block); }
  const Block* place_of(Index block) const { return &at(block); }

  /// A block for `count` windows; the rest of it has any value, but numbers where numbers were.
  Block& add(std::size_t count) {
    const std::size_t kind = size_class(std::max<std::size_t>(count, 1));
    Block& block = free_[kind] == no_index ? cut_from_page(kind) : take_free(kind);
    block.count = static_cast<std::uint32_t>(count);
    block.next = no_index;
    return block;
  }

  void release(Block& block) {
    block.next = free_[block.kind];
    free_[block.kind] = block.number;
  }

  std::size_t bytes() const { return units_ * sizeof(Block); }

 private:
  // A block's number is its page's number times `page_units`, plus its place in the page, in units of a Block's size.
  static constexpr std::size_t page_units = 1 << 11;
  static constexpr std::size_t steps = 4;  // sizes to an octave

  struct Free {
    void operator()(Block* page) const { ::operator delete (page, std::align_val_t{alignof(Block)}); }
  };

  Block& at(Index block) const { return *(pages_[block / page_units].get() + block % page_units); }

  /// The first capacity that is enough, of 1, 2, 3, 4 registers of `most_lanes`, then four steps to each doubling.
  static std::size_t size_class(std::size_t capacity) {
    const std::size_t last = (capacity - 1) / most_lanes;  // of its registers, from 0
    const int octave = std::max(0, static_cast<int>(std::bit_width(last / steps)) - 1);
    return steps * static_cast<std::size_t>(octave) + (last >> octave);
  }
  static std::size_t capacity_of(std::size_t kind) {
    if (kind < steps) return most_lanes * (kind + 1);
    const std::size_t octave = kind / steps - 1;
    return most_lanes * ((steps << octave) + (kind % steps + 1) * (std::size_t{1} << octave));
  }

  Block& take_free(std::size_t kind) {
    Block& block = at(free_[kind]);
    free_[kind] = block.next;
    return block;
  }
  Block& cut_from_page(std::size_t kind);

  std::vector<std::unique_ptr<Block, Free>> pages_;
  std::array<Index, 128> free_ = all_empty();
  std::size_t page_used_ = page_units;  ///< of the last page
  std::size_t units_ = 0;               ///< of all pages

  static constexpr std::array<Index, 128> all_empty() {
    std::array<Index, 128> none{};
    none.fill(no_index);
    return none;
  }
};

}  // namespace geodrome::chen_han
