// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
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
    Index half_edge = no_index, block = no_index, vertex = no_index;
  };
  /// Takes the next, and fetches the memory that those after it will need; `fetch_vertex(v)` is called for vertices
  /// that one of them will need. Precondition: not empty.
  template <class FetchVertex>
  Next pop(FetchVertex&& fetch_vertex) {
    BucketQueue::Entry entry;
    do entry = queue_.pop(), fetch_ahead(fetch_vertex);
    while (entry.key != slots_[entry.element].key);
    return taken(entry.element);
  }

  void push_vertex(Index vertex, double distance) { wait(half_edges_ + vertex, key_of(distance)); }

  /// Lets a block, which becomes the wavefront's, wait at every other half-edge on an edge. It is in the frame of one
  /// that runs against `edge`. What is farther than `limit` everywhere is dropped. Returns the number of windows that
  /// wait.
  std::size_t push_block(Index block, Index edge, double limit);

  /// A copy of a block, mirrored if the half-edge that it is for runs the same way as its edge, `length` long.
  Index copy_of(Index block, bool mirrored, double length);

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
    queue_.look_ahead(10, [&](Index soon) {
      prefetch(&slots_[soon]);
      if (soon >= half_edges_)
        prefetch(surface_.corners(soon - half_edges_).data());
      else
        prefetch_two_lines(surface_.face_of(soon));
    });
    queue_.look_ahead(4, [&](Index soon) {
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
      if (slots_[soon].block != no_index) prefetch(&store_[slots_[soon].block]);
    });
  }
  Next taken(Index element);
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
