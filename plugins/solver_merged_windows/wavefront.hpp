// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/prefetch.hpp"
#include "plugins/common/mesh/bucket_queue.hpp"
#include "plugins/solver_merged_windows/window.hpp"

namespace geodrome::merged_windows {

/// What waits: windows at half-edges and vertices that are to emit, nearest first. Windows of a half-edge are a chain
/// of runs: one of each entry in their order, then those that are loose.
class Wavefront {
 public:
  explicit Wavefront(const PackedMesh& surface)
      : surface_(surface),
        slots_(3 * surface.face_count() + surface.vertex_count()),
        half_edges_(static_cast<Index>(3 * surface.face_count())) {}

  /// Drops all that waits.
  void clear();
  bool empty() const { return waiting_ == 0; }

  /// What left the queue: a half-edge with the first of its windows, which are the caller's now, or a vertex.
  struct Next {
    Index half_edge = no_index, window = no_index, vertex = no_index;
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

  /// Lets windows, which are disjoint and ascend in the frame of a half-edge that runs against `edge`, wait at every
  /// other half-edge on the edge. What is farther than `limit` everywhere is dropped. Returns how many windows wait.
  std::size_t push_run(std::span<const Window> run, Index edge, double limit);

  /// The same for a window of the pool at one half-edge, `length` long. False if it was dropped.
  bool push_alone(Index window, const PackedMesh::Across& across, double length, double limit);

  /// The same for two.
  bool push_two(Index left, Index right, const PackedMesh::Across& across, double length, double limit);

  WindowPool& pool() { return pool_; }
  std::size_t bytes() const { return pool_.bytes() + queue_.bytes() + slots_.capacity() * sizeof(Slot); }

 private:
  static constexpr float not_waiting = std::numeric_limits<float>::infinity();

  struct Slot {
    float key = not_waiting;  ///< of the entry in the queue that counts
    Index first = no_index;
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
      if (slots_[soon].first != no_index) prefetch(&pool_[slots_[soon].first]);
    });
  }
  Next taken(Index element);
  void insert_run(Index first, Index last, Index half_edge);
  void wait(Index element, float key) {
    Slot& slot = slots_[element];
    waiting_ += slot.key == not_waiting;
    if (!(key < slot.key)) return;
    slot.key = key;
    queue_.push(element, key);
  }
  void chain(std::span<const Window> run, Index half_edge, bool mirrored, double length);

  const PackedMesh& surface_;
  std::vector<Slot> slots_;  ///< half-edges, then vertices
  Index half_edges_;
  BucketQueue queue_;
  WindowPool pool_;
  std::size_t waiting_ = 0;  ///< elements
};

/// Makes a window one as seen from a half-edge that runs the other way along the same edge, `length` long.
inline void mirror(Window& window, double length) {
  window.x = length - window.x;
  const double low = length - window.high;
  window.high = length - window.low, window.low = low;
  window.set_entry(mirrored(window.entry()));
}

}  // namespace geodrome::merged_windows
