// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// The length of a segment, without overflow or underflow of squares.
double segment_length(const Vec3& a, const Vec3& b);

/// The vertices and edges of a mesh as a graph in compressed rows, each edge once in each direction, neighbours
/// ascending; and the faces around each edge. Immutable.
class EdgeGraph {
 public:
  struct Arc {
    Index to;
    double length;
  };

  /// O(F log F).
  explicit EdgeGraph(const SurfaceMesh& mesh);

  std::size_t vertex_count() const { return first_.size() - 1; }
  std::span<const Arc> arcs(Index vertex) const {
    return {arcs_.data() + first_[vertex], arcs_.data() + first_[vertex + 1]};
  }
  /// The next half-edge on the same edge, whatever its direction: a ring through all faces of the edge.
  Index next_on_edge(Index half_edge) const { return next_on_edge_[half_edge]; }
  std::size_t bytes() const;

 private:
  std::vector<Index> first_;
  std::vector<Arc> arcs_;
  std::vector<Index> next_on_edge_;
};

}  // namespace geodrome
