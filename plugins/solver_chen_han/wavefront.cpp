// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/wavefront.hpp"

namespace geodrome::chen_han {
void Wavefront::clear() {
  while (!empty()) {
    for (Block* block = pop([](Index) {}).block; block;) {
      Block* following = block->next == no_index ? nullptr : &store_[block->next];
      store_.release(*block);
      block = following;
    }
  }
  queue_.clear();
}

std::size_t Wavefront::push_copies(Block& block, Index edge) {
  const double length = surface_.length(edge);
  std::size_t pushed = 0;
  if (surface_.is_fan(edge)) block.entry = Entry::loose;  // windows of other faces come to the same half-edges
  surface_.for_each_across(edge, [&](Index half_edge, bool mirrored) {
    push_block(copy_of(block, mirrored, length), half_edge, length);
    pushed += block.count;
  });
  store_.release(block);
  return pushed;
}

/// Seen from a half-edge that runs the same way as the edge, everything is mirrored.
Block& Wavefront::copy_of(Block& block, bool mirrored, double length) {
  const std::uint32_t count = block.count;
  Block& copy = store_.add(count);
  const WindowArrays from = block.windows(), to = copy.windows();
  copy.depth = block.depth, copy.near = block.near;
  copy.entry = mirrored ? geodrome::mirrored(block.entry) : block.entry;
  if (!mirrored) {
    copy_windows(from, count, to);
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      const Window w = from.get(i);
      to.set(count - 1 - i,
             {length - w.x, w.y, w.sigma, length - w.high, length - w.low, w.origin, w.parent | mirror_bits_});
    }
  }
  return copy;
}

}  // namespace geodrome::chen_han
