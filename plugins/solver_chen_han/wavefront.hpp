// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/surface_queue.hpp"
#include "plugins/solver_chen_han/window_store.hpp"

namespace geodrome::chen_han {

/// What waits: blocks of windows at half-edges and vertices that are to emit, in a queue, nearest first.
class Wavefront {
 public:
  explicit Wavefront(const PackedMesh& surface) : surface_(surface), queue_(surface) {}

  /// Drops all that waits.
  void clear();
  bool empty() const { return queue_.empty(); }
  /// Whether windows wait, not vertices alone.
  bool has_windows() const { return queue_.has_half_edges(); }
  /// Lets a mirrored window say so by these bits, set in its `parent`.
  void mark_mirrored(Index bits) { mirror_bits_ = bits; }

  /// What left the queue: a half-edge with the first of its blocks, which are the caller's now, or a vertex.
  struct Next {
    Block* block;  ///< null for a vertex
    Index element;
  };
  /// Takes the next, and fetches the memory that those after it will need; `fetch_vertex(v)` is called for vertices
  /// that one of them will need. Precondition: not empty.
  template <class FetchVertex>
  Next pop(FetchVertex&& fetch_vertex) {
    const SurfaceQueue::Next next = queue_.pop(fetch_vertex, [this](Index block) { prefetch(store_.place_of(block)); });
    return {next.is_vertex() ? nullptr : &store_[next.first], next.element};
  }

  void push_vertex(Index vertex, double distance) { queue_.push_vertex(vertex, distance); }

  /// Lets a block, which becomes the wavefront's, wait at a half-edge in whose frame it is, `length` long.
  /// Precondition: the block's `near` is set.
  void push_block(Block& block, Index half_edge, double length) {
    block.next = std::exchange(queue_.first(half_edge), block.number);
    queue_.push_half_edge(half_edge, block.near, length);
  }

  /// Lets copies of a block, which is released, wait at every other half-edge on an edge. The block is in the frame of
  /// one that runs against `edge`. Returns the number of windows that wait.
  std::size_t push_copies(Block& block, Index edge);

  /// A copy of a block, mirrored if the half-edge that it is for runs the same way as its edge, `length` long.
  Block& copy_of(Block& block, bool mirrored, double length);

  WindowStore& store() { return store_; }
  std::size_t bytes() const { return store_.bytes() + queue_.bytes(); }

 private:
  const PackedMesh& surface_;
  Index mirror_bits_ = 0;
  SurfaceQueue queue_;
  WindowStore store_;
};

}  // namespace geodrome::chen_han
