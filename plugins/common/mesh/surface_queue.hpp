// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/tolerances.hpp"
#include "plugins/common/mesh/bucket_queue.hpp"
#include "plugins/common/mesh/prefetch.hpp"

namespace geodrome {

/// The half-edges of a surface at which windows wait, and the vertices that are to emit, nearest first up to a bucket.
/// What waits at a half-edge is the caller's: a number says where it begins.
class SurfaceQueue {
 public:
  explicit SurfaceQueue(const PackedMesh& surface)
      : surface_(surface),
        slots_(3 * surface.face_count() + surface.vertex_count()),
        half_edges_(static_cast<Index>(3 * surface.face_count())) {}

  bool empty() const { return waiting_ == 0; }
  /// Whether half-edges wait, not vertices alone.
  bool has_half_edges() const { return waiting_half_edges_ > 0; }
  /// Drops stale entries. Precondition: empty.
  void clear() { queue_.clear(); }

  /// What left the queue: a half-edge with its number, which it has no longer, or a vertex (`first` is no_index).
  struct Next {
    Index element, first;
    bool is_vertex() const { return first == no_index; }
  };
  /// Takes the next, and fetches the memory that those after it will need: `fetch_vertex(v)` is called for vertices,
  /// `fetch_first(number)` for the number of a half-edge that one of them has. Precondition: not empty.
  template <class FetchVertex, class FetchFirst>
  Next pop(FetchVertex&& fetch_vertex, FetchFirst&& fetch_first) {
    BucketQueue::Entry entry;
    do entry = queue_.pop(), fetch_ahead(fetch_vertex, fetch_first);
    while (entry.key != slots_[entry.element].key);
    --waiting_, waiting_half_edges_ -= entry.element < half_edges_;
    Slot& slot = slots_[entry.element];
    slot.key = not_waiting;
    if (entry.element >= half_edges_) return {entry.element - half_edges_, no_index};
    return {entry.element, std::exchange(slot.first, no_index)};
  }

  /// The number of a half-edge; no_index if nothing waits there. Whoever sets it lets the half-edge wait.
  Index& first(Index half_edge) { return slots_[half_edge].first; }

  /// Lets a half-edge wait, at which windows arrived that are `near` at least, about. It keeps its place in the queue
  /// unless they are nearer by more than a quarter of the patience: hardly anything is carried on twice for that, and
  /// less is queued twice.
  void push_half_edge(Index half_edge, double near, double length) {
    const double patient = patience * length;
    const float key = key_of(near + patient), enough = static_cast<float>(0.25 * patient);
    const float present = slots_[half_edge].key;
    if (present == not_waiting || key < present - enough) wait(half_edge, key);
  }
  void push_vertex(Index vertex, double distance) { wait(half_edges_ + vertex, key_of(distance)); }

  std::size_t bytes() const { return queue_.bytes() + slots_.capacity() * sizeof(Slot); }

 private:
  static constexpr float not_waiting = std::numeric_limits<float>::infinity();

  struct Slot {
    float key = not_waiting;  ///< of the entry in the queue that counts
    Index first = no_index;
  };

  static float key_of(double distance) { return static_cast<float>(std::min(distance, 1e38)); }

  void wait(Index element, float key) {
    Slot& slot = slots_[element];
    if (slot.key == not_waiting) ++waiting_, waiting_half_edges_ += element < half_edges_;
    if (!(key < slot.key)) return;
    slot.key = key;
    queue_.push(element, key);
  }

  template <class FetchVertex, class FetchFirst>
  void fetch_ahead(FetchVertex&& fetch_vertex, FetchFirst&& fetch_first) const {
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
      if (slots_[soon].first != no_index) fetch_first(slots_[soon].first);
    });
  }

  const PackedMesh& surface_;
  std::vector<Slot> slots_;  ///< half-edges, then vertices
  Index half_edges_;
  BucketQueue queue_;
  std::size_t waiting_ = 0, waiting_half_edges_ = 0;  ///< elements, and those of them that are half-edges
};

}  // namespace geodrome
