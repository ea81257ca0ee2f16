// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/solver_kit/indexed_heap.hpp"
#include "plugins/solver_fast_marching/stencils.hpp"

namespace geodrome {

/// A front that marches over the vertices in the order of their distances (Kimmel and Sethian 1998): a vertex is
/// settled at the lowest value that settled ones gave it, each alone by the edge between them, or two of a triangle by
/// a plane front through both that comes from between them. No value is below the one settled last, so none is
/// revised. O(F log V). In lengths and numbers of the flat surface.
///
/// Reused: a new march costs what the last one reached. Not to be shared between threads.
class Front {
 public:
  explicit Front(const Stencils& stencils, std::size_t vertex_count)
      : stencils_(stencils), vertices_(vertex_count), heap_(vertex_count) {}

  /// Forgets the last march, even one that was stopped.
  void clear();
  /// A straight line within a face from source `source` leads to the vertex: no other way from that source is shorter,
  /// whatever plane fronts of that source alone make of it. Of equal distances the first source stays.
  void seed(Index vertex, double distance, Index source);
  /// The march may stop when every wanted vertex that can be reached is settled.
  void want(Index vertex);
  /// Settles all vertices up to `radius`; or, if `stop_at_wanted`, up to the farthest wanted one. May throw Cancelled.
  void march(double radius, bool stop_at_wanted, const RunContext& context);

  /// The vertices that were settled, nearest first.
  const std::vector<Index>& settled() const { return settled_; }
  double distance(Index vertex) const { return vertices_[vertex].distance; }
  Index source(Index vertex) const { return vertices_[vertex].source; }
  std::size_t bytes() const {
    return vertices_.size() * sizeof(Vertex) + heap_.bytes() +
           (settled_.capacity() + touched_.capacity()) * sizeof(Index);
  }

 private:
  static constexpr double unreached = infinity;

  struct Vertex {
    double distance = unreached;
    double settled = unreached;  ///< the distance, once it is settled
    Index source = no_index;
    bool straight = false, wanted = false;
  };
  struct Offer {
    double distance = unreached;
    Index source = no_index;
  };

  void pass(const Vertex& from, const Stencil& stencil, const Vertex& target, Offer& best) const;
  void pass_on(const Vertex& from, std::span<const Stencil> stencils);
  void lower(Index vertex, double distance, Index source);

  const Stencils& stencils_;
  std::vector<Vertex> vertices_;
  std::vector<Index> touched_, settled_;
  IndexedHeap heap_;
  std::size_t open_wanted_ = 0;
};

}  // namespace geodrome
