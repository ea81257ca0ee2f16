// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plugins/solver_aleksandrov/discretization.hpp"

namespace geodrome::aleksandrov {

/// A way over the triangulation of a graph, put together piece by piece, and given as a polyline of the mesh.
class TracedPath {
 public:
  explicit TracedPath(const Discretization& discretization) : discretization_(discretization) {}

  bool empty() const { return segments_.empty(); }

  /// Straight on from a place to a node it is joined to, from node to node, and from a node to a place.
  void to_node(const SurfacePoint& at, Index node);
  void between_nodes(Index from, Index to);
  void from_node(Index node, const SurfacePoint& at);
  /// Straight from place to place through faces around a vertex.
  void direct(const SurfacePoint& from, const SurfacePoint& to);

  /// Makes a way that lies in the faces at a vertex smaller by `scale`, towards the vertex.
  void shrink(Index vertex, double scale);

  /// Between a place and a node; infinity if they are not joined.
  double length_to_node(const SurfacePoint& at, Index node) const;

  /// Appends the points of the polyline but for its two ends, in the mesh's own numbers: where it bends and where it
  /// crosses edges. `from` and `to` are the names of the ends in the flat surface.
  void append_inner_points(const SurfacePoint& from, const SurfacePoint& to, std::vector<SurfacePoint>& out) const;

 private:
  /// A straight piece within a face of the graph's triangulation.
  struct Segment {
    Index face;
    Barycentric from, to;
  };
  struct Link;
  struct Finder;

  const SteinerGraph& graph() const { return discretization_.graph(); }
  template <class From>
  Link find(const From& from, Index node) const;
  void add(const Link& link, bool backwards);
  std::vector<Piece> pieces() const;
  void append_joint(const Piece& before, const Piece& after, std::vector<SurfacePoint>& out) const;

  const Discretization& discretization_;
  std::vector<Segment> segments_;
};

}  // namespace geodrome::aleksandrov
