// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/surface_queue.hpp"
#include "plugins/solver_merged_windows/window.hpp"

namespace geodrome::merged_windows {

/// What waits: windows at half-edges and vertices that are to emit, nearest first. Windows of a half-edge are a chain
/// of runs: one of each entry in their order, then those that are loose.
class Wavefront {
 public:
  explicit Wavefront(const PackedMesh& surface) : surface_(surface), queue_(surface) {}

  /// Drops all that waits.
  void clear();
  bool empty() const { return queue_.empty(); }

  /// Takes the next: a half-edge with the first of its windows, which are the caller's now, or a vertex. Fetches the
  /// memory that those after it will need; `fetch_vertex(v)` is called for vertices that one of them will need.
  /// Precondition: not empty.
  template <class FetchVertex>
  SurfaceQueue::Next pop(FetchVertex&& fetch_vertex) {
    return queue_.pop(fetch_vertex, [this](Index window) { prefetch(&pool_[window]); });
  }

  void push_vertex(Index vertex, double distance) { queue_.push_vertex(vertex, distance); }

  /// Lets windows, which are disjoint and ascend in the frame of a half-edge that runs against `edge`, wait at every
  /// other half-edge on the edge. What is farther than `limit` everywhere is dropped. Returns how many windows wait.
  std::size_t push_run(std::span<const Window> run, Index edge, double limit);

  /// The same for a window of the pool at one half-edge, `length` long. False if it was dropped.
  bool push_alone(Index window, const PackedMesh::Across& across, double length, double limit);

  /// The same for two.
  bool push_two(Index left, Index right, const PackedMesh::Across& across, double length, double limit);

  WindowPool& pool() { return pool_; }
  std::size_t bytes() const { return pool_.bytes() + queue_.bytes(); }

 private:
  void insert_run(Index first, Index last, Index half_edge);
  void chain(std::span<const Window> run, Index half_edge, bool mirrored, double length);

  const PackedMesh& surface_;
  SurfaceQueue queue_;
  WindowPool pool_;
};

/// Makes a window one as seen from a half-edge that runs the other way along the same edge, `length` long.
inline void mirror(Window& window, double length) {
  window.x = length - window.x;
  const double low = length - window.high;
  window.high = length - window.low, window.low = low;
  window.set_entry(mirrored(window.entry()));
}

}  // namespace geodrome::merged_windows
