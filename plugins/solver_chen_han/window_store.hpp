// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "plugins/common/exact/entry.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// Windows that wait at a half-edge, ordered along it and disjoint.
struct Block {
  double* memory;
  std::uint32_t first, count, capacity;
  Index next;   ///< block at the same half-edge, no_index after the last
  Index depth;  ///< faces crossed since the pseudo-source, at least
  Entry entry;  ///< of all its windows

  WindowArrays windows() const { return WindowArrays(memory, capacity).without(first); }
};

/// The memory of waiting windows: blocks cut from pages and used again by size, so that it holds the wavefront and no
/// more. Nothing is given back before the end.
class WindowStore {
 public:
  const Block& operator[](Index block) const { return blocks_[block]; }
  Block& operator[](Index block) { return blocks_[block]; }

  /// A block for `count` windows and padding; the rest of it has any value.
  Index add(std::size_t count) {
    Index block;
    if (free_block_ == no_index) {
      block = static_cast<Index>(blocks_.size());
      blocks_.push_back({});
    } else {
      block = free_block_, free_block_ = blocks_[block].next;
    }
    const std::size_t kind = size_class(count + padding), capacity = capacity_of(kind);
    blocks_[block].memory = take(kind);
    blocks_[block].first = 0;
    blocks_[block].count = static_cast<std::uint32_t>(count);
    blocks_[block].capacity = static_cast<std::uint32_t>(capacity);
    blocks_[block].next = no_index;
    return block;
  }

  void release(Index block) {
    free_[size_class(blocks_[block].capacity)].push_back(blocks_[block].memory);
    blocks_[block].next = free_block_;
    free_block_ = block;
  }

  std::size_t bytes() const { return page_doubles_ * sizeof(double) + blocks_.capacity() * sizeof(Block); }

 private:
  static constexpr std::size_t page_size = 1 << 13;  // doubles
  static constexpr std::size_t steps = 4;            // sizes to an octave

  /// The first capacity that is enough, of 4, 8, 12, 16, then four steps to each doubling.
  static std::size_t size_class(std::size_t capacity) {
    const std::size_t last = (capacity - 1) / 4;  // of its fours, from 0
    const int octave = std::max(0, static_cast<int>(std::bit_width(last / steps)) - 1);
    return steps * static_cast<std::size_t>(octave) + (last >> octave);
  }
  static std::size_t capacity_of(std::size_t kind) {
    return kind < steps ? 4 * (kind + 1) : (16 << (kind / steps - 1)) + (kind % steps + 1) * (4 << (kind / steps - 1));
  }

  double* take(std::size_t kind) {
    if (!free_[kind].empty()) {
      double* memory = free_[kind].back();
      free_[kind].pop_back();
      return memory;
    }
    const std::size_t size = capacity_of(kind) * WindowArrays::doubles_per_window;
    if (size > page_left_) {
      page_left_ = std::max(size, page_size);
      pages_.push_back(std::make_unique_for_overwrite<double[]>(page_left_));
      page_ = pages_.back().get();
      page_doubles_ += page_left_;
    }
    double* memory = page_;
    page_ += size, page_left_ -= size;
    return memory;
  }

  std::vector<Block> blocks_;
  Index free_block_ = no_index;
  std::array<std::vector<double*>, 128> free_;
  std::vector<std::unique_ptr<double[]>> pages_;
  double* page_ = nullptr;
  std::size_t page_left_ = 0, page_doubles_ = 0;
};

}  // namespace geodrome::chen_han
