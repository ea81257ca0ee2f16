// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/tolerances.hpp"
#include "plugins/common/mesh/bucket_queue.hpp"
#include "plugins/common/mesh/prefetch.hpp"
#include "plugins/solver_chen_han/window_store.hpp"

namespace geodrome::chen_han {

/// What waits: blocks of windows at half-edges and vertices that are to emit, in a queue, nearest first.
class Wavefront {
 public:
  explicit Wavefront(const PackedMesh& surface)
      : surface_(surface),
        slots_(3 * surface.face_count() + surface.vertex_count()),
        half_edges_(static_cast<Index>(3 * surface.face_count())) {}

  /// Drops all that waits.
  void clear();
  bool empty() const { return waiting_ == 0; }

  /// What left the queue: a half-edge with the first of its blocks, which are the caller's now, or a vertex.
  struct Next {
    Block* block;  ///< null for a vertex
    Index element;
  };
  /// Takes the next, and fetches the memory that those after it will need; `fetch_vertex(v)` is called for vertices
  /// that one of them will need. Precondition: not empty.
  template <class FetchVertex>
  Next pop(FetchVertex&& fetch_vertex) {
    BucketQueue::Entry entry;
    do entry = queue_.pop(), fetch_ahead(fetch_vertex);
    while (entry.key != slots_[entry.element].key);
    --waiting_;
    Slot& slot = slots_[entry.element];
    slot.key = not_waiting;
    if (entry.element >= half_edges_) return {nullptr, entry.element - half_edges_};
    return {&store_[std::exchange(slot.block, no_index)], entry.element};
  }

  void push_vertex(Index vertex, double distance) { wait(half_edges_ + vertex, key_of(distance)); }

  /// Lets a block, which becomes the wavefront's, wait at a half-edge in whose frame it is, `length` long.
  /// Precondition: the block's `near` is set. A half-edge that waits keeps its place in the queue unless the block is
  /// nearer by more than a quarter of the patience: hardly anything is carried on twice for that, and less is queued
  /// twice.
  void push_block(Block& block, Index half_edge, double length) {
    const Slot& slot = slots_[half_edge];
    block.next = slot.block;
    slots_[half_edge].block = block.number;
    const float key = key_of(block.near + patience * length), enough = static_cast<float>(0.25 * patience * length);
    if (slot.key == not_waiting || key < slot.key - enough) wait(half_edge, key);
  }

  /// Lets copies of a block, which is released, wait at every other half-edge on an edge. The block is in the frame of
  /// one that runs against `edge`. Returns the number of windows that wait.
  std::size_t push_copies(Block& block, Index edge);

  /// A copy of a block, mirrored if the half-edge that it is for runs the same way as its edge, `length` long.
  Block& copy_of(Block& block, bool mirrored, double length);

  WindowStore& store() { return store_; }
  std::size_t bytes() const { return store_.bytes() + queue_.bytes() + slots_.capacity() * sizeof(Slot); }

 private:
  static constexpr float not_waiting = std::numeric_limits<float>::infinity();

  struct Slot {
    float key = not_waiting;  ///< of the entry in the queue that counts
    Index block = no_index;   ///< the first
  };

  static float key_of(double distance) { return static_cast<float>(std::min(distance, 1e38)); }
  template <class FetchVertex>
  void fetch_ahead(FetchVertex&& fetch_vertex) const {
    queue_.look_ahead(8, [&](Index soon) {
      prefetch(&slots_[soon]);
      if (soon >= half_edges_)
        prefetch(surface_.corners(soon - half_edges_).data());
      else
        prefetch_two_lines(surface_.face_of(soon));
    });
    queue_.look_ahead(3, [&](Index soon) {
      if (soon >= half_edges_) {
        for (const Index corner : surface_.corners(soon - half_edges_)) prefetch_two_lines(surface_.face_of(corner));
        return;
      }
      const PackedMesh::Face& face = surface_.face_of(soon);
      for (int i = 0; i < 3; ++i) {
        fetch_vertex(face.vertex[i]);
        const Index across = PackedMesh::only_across(face, i).half_edge;
        if (across != no_index) prefetch(&slots_[across]);
      }
      if (slots_[soon].block != no_index) prefetch(store_.place_of(slots_[soon].block));
    });
  }
  void wait(Index element, float key) {
    Slot& slot = slots_[element];
    waiting_ += slot.key == not_waiting;
    if (!(key < slot.key)) return;
    slot.key = key;
    queue_.push(element, key);
  }

  const PackedMesh& surface_;
  std::vector<Slot> slots_;  ///< half-edges, then vertices
  Index half_edges_;
  BucketQueue queue_;
  WindowStore store_;
  std::size_t waiting_ = 0;  ///< elements
};

}  // namespace geodrome::chen_han
