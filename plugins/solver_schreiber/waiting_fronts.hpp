// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "geodrome/solver_kit/indexed_heap.hpp"
#include "plugins/common/exact/entry.hpp"
#include "plugins/solver_schreiber/front.hpp"

namespace geodrome::schreiber {

/// The course of a front: how it came to a half-edge.
struct Course {
  Index depth = 1;  ///< lower bound of the faces crossed since the pseudo-source
  double low = -infinity,
         high = infinity;  ///< its claim on the half-edge before; if it is several fronts, from the first to the last

  /// Tells whether the rays of this front crossed the half-edge before to the left of those of another front that came
  /// through it.
  bool is_left_of(const Course& other) const { return high <= other.low; }
  /// Returns the course as seen from a half-edge that runs the other way.
  Course mirrored() const { return {depth, -high, -low}; }
  /// Returns the course of the front that two fronts make together.
  Course with(const Course& other) const {
    return {std::min(depth, other.depth), std::min(low, other.low), std::max(high, other.high)};
  }
};

/// A front that waits at a half-edge.
struct Arrival {
  Front front;
  Ends ends;
  Entry entry;
  Course course;
};

/// The queue: fronts that wait at half-edges and vertices that are to emit, nearest first.
class WaitingFronts {
 public:
  WaitingFronts(std::size_t half_edge_count, std::size_t vertex_count)
      : first_(half_edge_count, no_index), queue_(half_edge_count + vertex_count) {}

  bool empty() const { return queue_.empty(); }

  void push_vertex(Index vertex, double distance) { queue_.push(static_cast<Index>(first_.size()) + vertex, distance); }
  void push(Index half_edge, double key, Arrival arrival) {
    const Index slot = free_.empty() ? static_cast<Index>(slots_.size()) : free_.back();
    if (free_.empty())
      slots_.emplace_back();
    else
      free_.pop_back();
    slots_[slot] = {std::move(arrival), first_[half_edge]};
    first_[half_edge] = slot;
    queue_.push(half_edge, key);
  }

  /// Takes the nearest half-edge or vertex. `arrivals` gets the fronts that waited at a half-edge, the last one first.
  struct Next {
    Index half_edge = no_index, vertex = no_index;
  };
  Next pop(std::vector<Arrival>& arrivals) {
    const Index element = queue_.pop();
    arrivals.clear();
    if (element >= first_.size()) return {no_index, element - static_cast<Index>(first_.size())};
    for (Index slot = std::exchange(first_[element], no_index); slot != no_index; slot = slots_[slot].next) {
      arrivals.push_back(std::move(slots_[slot].arrival));
      free_.push_back(slot);
    }
    return {element, no_index};
  }

  /// Drops everything that waits.
  void clear() {
    std::vector<Arrival> dropped;
    while (!empty()) pop(dropped);
  }

  std::size_t bytes() const {
    return queue_.bytes() + (first_.capacity() + free_.capacity()) * sizeof(Index) + slots_.capacity() * sizeof(Slot);
  }

 private:
  struct Slot {
    Arrival arrival;
    Index next;
  };
  std::vector<Index> first_;  ///< slot of each half-edge
  std::vector<Slot> slots_;
  std::vector<Index> free_;
  IndexedHeap queue_;  ///< half-edges, then vertices
};

}  // namespace geodrome::schreiber
