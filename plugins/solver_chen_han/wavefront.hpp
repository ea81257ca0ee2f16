// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "geodrome/solver_kit/indexed_heap.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_chen_han/window_store.hpp"

namespace geodrome::chen_han {

/// What waits: blocks of windows at half-edges and vertices that are to emit, in a queue, nearest first.
class Wavefront {
 public:
  explicit Wavefront(const PackedMesh& surface)
      : surface_(surface),
        waiting_(3 * surface.face_count(), no_index),
        queue_(3 * surface.face_count() + surface.vertex_count()) {}

  /// Drops all that waits.
  void clear();
  bool empty() const { return queue_.empty(); }

  /// What left the queue: a half-edge with the first of its blocks, which are the caller's now, or a vertex.
  struct Next {
    Index half_edge = no_index, block = no_index, vertex = no_index;
  };
  Next pop();

  void push_vertex(Index vertex, double distance) {
    queue_.push(static_cast<Index>(waiting_.size()) + vertex, distance);
  }

  /// Lets a block, which becomes the wavefront's, wait at every other half-edge on an edge. It is in the frame of one
  /// that runs against `edge`. What is farther than `limit` everywhere is dropped. Returns the number of windows that
  /// wait.
  std::size_t push_block(Index block, Index edge, double limit);

  /// A copy of a block, mirrored if the half-edge that it is for runs the same way as its edge, `length` long.
  Index copy_of(Index block, bool mirrored, double length);

  WindowStore& store() { return store_; }
  std::size_t bytes() const { return store_.bytes() + queue_.bytes() + waiting_.capacity() * sizeof(Index); }

 private:
  const PackedMesh& surface_;
  std::vector<Index> waiting_;  ///< first block of each half-edge
  IndexedHeap queue_;           ///< half-edges, then vertices
  WindowStore store_;
};

}  // namespace geodrome::chen_han
