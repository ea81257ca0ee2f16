// SPDX-License-Identifier: MIT
#pragma once

// Included by steiner_graph.hpp alone, after SteinerGraph.
#include "plugins/solver_aleksandrov/cheapest_crossing.hpp"

namespace geodrome::aleksandrov {

/// The edges of a Steiner graph on a weighted surface: two places are joined by the cheapest way that touches one edge
/// of the triangulation and otherwise stays in two of its faces, or in one: it may go back where the edge is cheaper
/// than the face. Ways that leave the edge by an end are left out: that is a vertex.
template <class Visit>
class WeightedEdges {
 public:
  WeightedEdges(const SteinerGraph& graph, Visit& visit) : graph_(graph), visit_(visit) {}

  void from_vertex(Index vertex) const {
    for (const Index h : graph_.corners_at(vertex)) {
      const Index opposite = SurfaceMesh::next(h), before = SurfaceMesh::previous(h);
      // Each face at the vertex sees to itself.
      into(h, {0, 0}, h);
      into(before, {graph_.corner(before).length, 0}, before);
      over(opposite, graph_.corner(opposite).apex);
    }
  }

  void from_steiner_point(Index node) const {
    const Index h = graph_.corner_of(node), before = SurfaceMesh::previous(h);
    const Point2 p = graph_.in_frame(h, node);
    to_corners(h, p);
    over(h, p);
    over(before, {graph_.corner(before).length - p.x, p.y});
  }

  void from_place(const SurfacePoint& at) const {
    to_corners(3 * at.face, graph_.in_frame(3 * at.face, at.b));
    for (Index h = 3 * at.face; h < 3 * at.face + 3; ++h) over(h, graph_.in_frame(h, at.b));
  }

 private:
  /// Straight.
  void to_corners(Index h, Point2 p) const {
    visit_.via(h, p, no_index);
    for (const Index c : {h, SurfaceMesh::next(h), SurfaceMesh::previous(h)})
      visit_.vertex(c, graph_.weight(h / 3) * length(p - graph_.corner_in_frame(h, c)));
  }

  /// By way of the edge of `h` into all its faces.
  void over(Index h, Point2 p) const {
    Index g = h;
    do into(h, p, g);
    while ((g = graph_.corner(g).next_on_edge) != h);
  }

  /// By way of the edge of `h` into the face of `g`: the bisectors at the ends of the edge, and all corners.
  void into(Index h, Point2 p, Index g) const {
    visit_.via(h, p, g);
    for (const Index c : {g, SurfaceMesh::next(g), SurfaceMesh::previous(g)}) {
      const Crossing way = graph_.crossing(h, p, g, graph_.corner_in_frame(g, c));
      if (graph_.on_edge(h, way)) visit_.vertex(c, way.cost);
    }
    const auto &start = graph_.corner(g), &end = graph_.corner(SurfaceMesh::next(g));
    bisector(h, p, g, start, {0, 0}, {start.cosine, start.sine});
    bisector(h, p, g, end, {start.length, 0}, {-end.cosine, end.sine});
  }

  /// Of points that would be too far even if all of the way cost what the edge does, nothing more is computed.
  void bisector(Index h, Point2 p, Index g, const SteinerGraph::Corner& c, Point2 vertex, Point2 along) const {
    for (Index node = c.first; node < c.last; ++node) {
      const Point2 q = vertex + graph_.distances()[node] * along;
      if (!visit_.wants(node, graph_.edge_weight(h) * length(p - graph_.unfolded(h, g, q)))) continue;
      const Crossing way = graph_.crossing(h, p, g, q);
      if (graph_.on_edge(h, way)) visit_.point(node, way.cost);
    }
  }

  const SteinerGraph& graph_;
  Visit& visit_;
};

}  // namespace geodrome::aleksandrov
