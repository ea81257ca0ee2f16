// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "plugins/solver_aleksandrov/cheapest_crossing.hpp"
#include "plugins/solver_aleksandrov/intrinsic/triangulation.hpp"
#include "plugins/solver_aleksandrov/steiner_points.hpp"

namespace geodrome::aleksandrov {

template <class Visit>
class WeightedEdges;

/// The graph of Aleksandrov, Maheshwari and Sack: nodes are the vertices of a triangulation and Steiner points on the
/// bisectors of its angles; edges are straight segments through at most two faces. Edges are not stored: they are
/// strips, the Steiner points of one bisector that are seen from a place through an edge. Immutable.
///
/// Nodes: vertices first, then the Steiner points, corner by corner, outwards.
class SteinerGraph {
 public:
  struct Corner {
    double length;        ///< of the half-edge
    double cosine, sine;  ///< of half the angle
    Point2 apex;          ///< in the frame of the half-edge
    Index vertex;
    Index next_on_edge;
    Index first, last;  ///< Steiner points: nodes [first, last)
    bool forward;
  };

  /// Steiner points [first, last) of one bisector as seen from a place: the one at distance t from its vertex is
  /// |(x - t dx, y - t dy)| away.
  struct Strip {
    Index first, last;
    double x, y, dx, dy;
  };

  /// The points of the placement must be counted before: `Index` has to hold their number, and memory them.
  SteinerGraph(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement);

  Index vertex_count() const { return static_cast<Index>(first_corner_.size() - 1); }
  Index node_count() const { return static_cast<Index>(distance_.size()); }
  Index face_count() const { return static_cast<Index>(corners_.size() / 3); }
  const Corner& corner(Index h) const { return corners_[h]; }
  /// The half-edge whose corner a Steiner point belongs to.
  Index corner_of(Index node) const { return corner_of_[node - vertex_count()]; }
  /// Distances of nodes from the vertex of their bisector; 0 for vertices.
  const double* distances() const { return distance_.data(); }
  /// The half-edges that start at a vertex, one in each face at it.
  std::span<const Index> corners_at(Index vertex) const {
    return {corners_at_.data() + first_corner_[vertex], corners_at_.data() + first_corner_[vertex + 1]};
  }

  /// A Steiner point in the frame of half-edge `h` of its face.
  Point2 in_frame(Index h, Index node) const;
  /// Where corner `c` of the face of `h` is in the frame of `h`.
  Point2 corner_in_frame(Index h, Index c) const {
    return c == h ? Point2{0, 0} : c == SurfaceMesh::next(h) ? Point2{corners_[h].length, 0} : corners_[h].apex;
  }
  /// From barycentric coordinates in the face of `h`.
  Point2 in_frame(Index h, const Barycentric& b) const;
  Barycentric coordinates(Index h, Point2 p) const;

  /// Calls, for all that is joined to a node: `visit.via(h, p, g)`, the place as p in the frame of half-edge h, and
  /// where it looks through that edge the half-edge g beyond it, else no_index; then for what it sees there
  /// `visit.vertex(corner, distance)`, the half-edge that starts at the vertex, and `visit.strip(strip)`; on a weighted
  /// surface `visit.point(node, distance)` for each Steiner point instead, if `visit.wants(node, distance)` with a
  /// lower bound, and h itself as g where it looks back.
  template <class Visit>
  void for_each_edge(Index node, Visit&& visit) const;
  /// The same for a place in a face that is no vertex.
  template <class Visit>
  void for_each_edge(const SurfacePoint& at, Visit&& visit) const;

  /// How the frame of `g`, on the same edge, lies in that of `h`: a point of its face unfolded below the edge.
  Point2 unfolded(Index h, Index g, Point2 p) const {
    const Corner &here = corners_[h], &there = corners_[g];
    return {here.forward == there.forward ? p.x : here.length - p.x, -p.y};
  }

  /// Calls `visit(name)` for every face that holds a place that is no vertex: its own, then the others on its edge.
  template <class Visit>
  void for_each_name(const SurfacePoint& at, Visit&& visit) const;

  /// The length of the edge to the point of a strip at distance t from its vertex.
  static double length(const Strip& s, double t) { return std::hypot(s.x - t * s.dx, s.y - t * s.dy); }

  bool weighted() const { return !weights_.empty(); }
  /// What a unit of length costs in a face.
  double weight(Index face) const { return weights_.empty() ? 1 : weights_[face]; }
  double edge_weight(Index h) const { return edge_weights_.empty() ? 1 : edge_weights_[h]; }
  /// The cheapest way from `p` in the frame of `h` by its edge to `q` in the frame of `g`.
  Crossing crossing(Index h, Point2 p, Index g, Point2 q) const;
  /// Whether a way touches the edge of `h` between its ends.
  bool on_edge(Index h, const Crossing& way) const {
    const double slack = 1e-14 * corners_[h].length, low = -slack, high = corners_[h].length + slack;
    return std::min(way.leave, way.enter) >= low && std::max(way.leave, way.enter) <= high;
  }

  std::size_t bytes() const;

 private:
  void weigh(const IntrinsicTriangulation& triangulation);
  void add_points(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement);
  Strip own_strip(Index h, Point2 p) const {
    const Corner& c = corners_[h];
    return {c.first, c.last, p.x, p.y, c.cosine, c.sine};
  }
  template <class Visit>
  void through_edge(Index h, Point2 p, Visit&& visit) const;
  template <class Visit>
  void bisector_through(const Corner& bisector, double length, Point2 p, Visit&& visit) const;

  std::vector<Corner> corners_;
  std::vector<double> distance_;
  std::vector<Index> corner_of_;
  std::vector<Index> first_corner_, corners_at_;
  std::vector<double> weights_, edge_weights_;  ///< per face and per half-edge; empty: all 1
};

}  // namespace geodrome::aleksandrov

#include "plugins/solver_aleksandrov/weighted_edges.hpp"

namespace geodrome::aleksandrov {

/// A bisector beyond the edge that starts at the start of that edge; `p` is above, x from there.
template <class Visit>
void SteinerGraph::bisector_through(const Corner& bisector, double length, Point2 p, Visit&& visit) const {
  const double c = bisector.cosine, s = bisector.sine;
  if (bisector.first == bisector.last || p.x * s + p.y * c < 0) return;  // past the start
  Strip strip{bisector.first, bisector.last, p.x, p.y, c, -s};
  const double growth = (p.x - length) * s + c * p.y, most = length * p.y;
  if (growth > 0) {
    // Past the end from distance most / growth on.
    const double* t = distance_.data();
    strip.last = static_cast<Index>(std::upper_bound(t + strip.first, t + strip.last, most / growth) - t);
  }
  if (strip.first < strip.last) visit.strip(strip);
}

/// All that is seen from `p`, in the frame of `h`, through its edge. Straight segments that would miss the edge are
/// left out: the way through its end is as short.
template <class Visit>
void SteinerGraph::through_edge(Index h, Point2 p, Visit&& visit) const {
  const Corner& here = corners_[h];
  const Point2 flipped{here.length - p.x, p.y};
  for (Index g = here.next_on_edge; g != h; g = corners_[g].next_on_edge) {
    const Corner &start = corners_[g], &end = corners_[SurfaceMesh::next(g)];
    const bool same = start.forward == here.forward;
    visit.via(h, p, g);
    bisector_through(start, here.length, same ? p : flipped, visit);
    bisector_through(end, here.length, same ? flipped : p, visit);
    const Point2 apex = unfolded(h, g, start.apex);
    const double rise = p.y - apex.y, x = p.x * -apex.y + apex.x * p.y;
    if (x >= 0 && x <= here.length * rise) visit.vertex(SurfaceMesh::previous(g), std::hypot(p.x - apex.x, rise));
  }
}

template <class Visit>
void SteinerGraph::for_each_edge(Index node, Visit&& visit) const {
  if (weighted()) {
    const WeightedEdges edges(*this, visit);
    return node < vertex_count() ? edges.from_vertex(node) : edges.from_steiner_point(node);
  }
  if (node < vertex_count()) {
    for (const Index h : corners_at(node)) {
      const Index opposite = SurfaceMesh::next(h), before = SurfaceMesh::previous(h);
      const Corner &own = corners_[h], &next = corners_[opposite], &last = corners_[before];
      visit.via(h, Point2{0, 0}, no_index);
      visit.vertex(opposite, own.length);
      visit.vertex(before, last.length);
      visit.strip(own_strip(h, {0, 0}));
      visit.via(opposite, next.apex, no_index);
      visit.strip(own_strip(opposite, next.apex));
      visit.via(before, Point2{last.length, 0}, no_index);
      visit.strip(own_strip(before, {last.length, 0}));
      through_edge(opposite, next.apex, visit);
    }
    return;
  }
  const Index h = corner_of(node), before = SurfaceMesh::previous(h);
  const Point2 p = in_frame(h, node);
  const Corner &own = corners_[h], &last = corners_[before];
  visit.via(h, p, no_index);
  visit.vertex(h, distance_[node]);
  visit.vertex(SurfaceMesh::next(h), aleksandrov::length(p - Point2{own.length, 0}));
  visit.vertex(before, aleksandrov::length(p - own.apex));
  through_edge(h, p, visit);
  through_edge(before, {last.length - p.x, p.y}, visit);
}

template <class Visit>
void SteinerGraph::for_each_edge(const SurfacePoint& at, Visit&& visit) const {
  if (weighted()) return WeightedEdges(*this, visit).from_place(at);
  for (Index i = 0; i < 3; ++i) {
    const Index h = 3 * at.face + i;
    const Point2 p = in_frame(h, at.b);
    visit.via(h, p, no_index);
    visit.vertex(h, aleksandrov::length(p));
    through_edge(h, p, visit);
  }
}

template <class Visit>
void SteinerGraph::for_each_name(const SurfacePoint& at, Visit&& visit) const {
  visit(at);
  for (Index i = 0; i < 3; ++i) {
    if (at.b[i] != 0) continue;
    const Index h = 3 * at.face + (i + 1) % 3;
    for (Index g = corners_[h].next_on_edge; g != h; g = corners_[g].next_on_edge) {
      const bool same = corners_[g].forward == corners_[h].forward;
      SurfacePoint there{g / 3, {}};
      there.b[g % 3] = at.b[(i + (same ? 1 : 2)) % 3];
      there.b[(g + 1) % 3] = at.b[(i + (same ? 2 : 1)) % 3];
      visit(there);
    }
  }
}

}  // namespace geodrome::aleksandrov
