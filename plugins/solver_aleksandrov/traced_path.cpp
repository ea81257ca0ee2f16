// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/traced_path.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/solver_aleksandrov/direct_way.hpp"
#include "plugins/solver_aleksandrov/joint.hpp"
#include "plugins/solver_aleksandrov/source_star.hpp"

namespace geodrome::aleksandrov {
namespace {

Barycentric corner_coordinates(Index h) {
  Barycentric b{};
  b[h % 3] = 1;
  return b;
}

Barycentric on_edge(Index h, double length, double x) {
  const double share = length > 0 ? std::clamp(x / length, 0.0, 1.0) : 0;
  Barycentric b{};
  b[h % 3] = 1 - share, b[(h + 1) % 3] = share;
  return b;
}

/// Whether a face of the flat surface holds a point that is named in another one.
bool holds(const PackedMesh& surface, Index face, const SurfacePoint& point) {
  for (Index i = 0; i < 3; ++i)
    if (point.b[i] == 1) {
      const auto& vertex = surface.face(face).vertex;
      return std::find(vertex, vertex + 3, surface.from(3 * point.face + i)) != vertex + 3;
    }
  bool found = false;
  surface.for_each_name(point, [&](const SurfacePoint& name) { found = found || name.face == face; });
  return found;
}

}  // namespace

/// A straight way from a place, p in the frame of half-edge h, to a node: within the face, or through the edge of h and
/// out of that of g.
struct TracedPath::Link {
  double distance = infinity;
  Index h = no_index, g = no_index;
  Point2 p;
  Barycentric end{};  ///< of the node, in the face of g or else of h
};

struct TracedPath::Finder {
  const SteinerGraph& graph;
  Index node;
  Link best, now;

  void via(Index h, Point2 p, Index g) { now.h = h, now.p = p, now.g = g; }
  void vertex(Index corner, double distance) {
    if (graph.corner(corner).vertex == node && distance < best.distance) take(distance, corner_coordinates(corner));
  }
  void strip(const SteinerGraph::Strip& s) {
    if (node >= s.first && node < s.last) point(node, SteinerGraph::length(s, graph.distances()[node]));
  }
  bool wants(Index seen, double) const { return seen == node; }
  void point(Index found, double distance) {
    if (found != node) return;
    const Index h = graph.corner_of(node);
    if (distance < best.distance) take(distance, graph.coordinates(h, graph.in_frame(h, node)));
  }
  void take(double distance, const Barycentric& end) {
    best = now;
    best.distance = distance, best.end = end;
  }
};

template <class From>
TracedPath::Link TracedPath::find(const From& from, Index node) const {
  Finder finder{graph(), node, {}, {}};
  graph().for_each_edge(from, finder);
  return finder.best;
}

void TracedPath::add(const Link& link, bool backwards) {
  const auto& here = graph().corner(link.h);
  Barycentric start = graph().coordinates(link.h, link.p);
  for (const Index c : {link.h, SurfaceMesh::next(link.h), SurfaceMesh::previous(link.h)}) {
    const Point2 corner = graph().corner_in_frame(link.h, c);
    if (corner.x == link.p.x && corner.y == link.p.y) start = corner_coordinates(c);
  }
  std::vector<Segment> added;
  if (link.g == no_index) {
    added.push_back({link.h / 3, start, link.end});
  } else {
    const Crossing way = graph().crossing(link.h, link.p, link.g, graph().in_frame(link.g, link.end));
    const bool same = graph().corner(link.g).forward == here.forward;
    added.push_back({link.h / 3, start, on_edge(link.h, here.length, way.leave)});
    if (way.leave != way.enter) added.push_back({link.h / 3, added.back().to, on_edge(link.h, here.length, way.enter)});
    added.push_back({link.g / 3, on_edge(link.g, here.length, same ? way.enter : here.length - way.enter), link.end});
  }
  if (backwards) {
    std::reverse(added.begin(), added.end());
    for (Segment& segment : added) std::swap(segment.from, segment.to);
  }
  segments_.insert(segments_.end(), added.begin(), added.end());
}

void TracedPath::to_node(const SurfacePoint& at, Index node) { add(find(at, node), false); }
// As the search went: rounding may hide an edge from its other end.
void TracedPath::between_nodes(Index from, Index to) { add(find(to, from), true); }
void TracedPath::from_node(Index node, const SurfacePoint& at) { add(find(at, node), true); }

double TracedPath::length_to_node(const SurfacePoint& at, Index node) const { return find(at, node).distance; }

// As the search went, from there to here: rounding may hide the way from its other end.
void TracedPath::direct(const SurfacePoint& from, const SurfacePoint& to) {
  const std::vector<DirectWay::Crossing> crossings = direct_way(graph(), to, from).crossings;
  Index face = from.face;
  Barycentric start = from.b;
  for (auto crossing = crossings.rbegin(); crossing != crossings.rend(); ++crossing) {
    const auto& [g, h, x] = *crossing;
    const double length = graph().corner(h).length;
    const bool same = graph().corner(g).forward == graph().corner(h).forward;
    segments_.push_back({face, start, on_edge(h, length, same ? x : length - x)});
    face = g / 3, start = on_edge(g, length, x);
  }
  segments_.push_back({face, start, to.b});
}

void TracedPath::shrink(Index vertex, double scale) {
  for (Segment& segment : segments_) {
    Index corner = 3;
    for (Index i = 0; i < 3; ++i)
      if (graph().corner(3 * segment.face + i).vertex == vertex && (corner == 3 || segment.to[i] > segment.to[corner]))
        corner = i;
    segment.from = scaled({segment.face, segment.from}, corner, 1 / scale).b;
    segment.to = scaled({segment.face, segment.to}, corner, 1 / scale).b;
  }
}

/// In faces of the flat surface; pieces of one straight segment in one face are one.
std::vector<Piece> TracedPath::pieces() const {
  std::vector<Piece> all, part;
  for (const Segment& segment : segments_) {
    part.clear();
    discretization_.restore(segment.face, segment.from, segment.to, part);
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (i > 0 && all.back().triangle == part[i].triangle)
        all.back().to = part[i].to;
      else
        all.push_back(part[i]);
    }
  }
  return all;
}

/// The point between two pieces must lie in the faces of both.
void TracedPath::append_joint(const Piece& before, const Piece& after, std::vector<SurfacePoint>& out) const {
  const PackedMesh& surface = discretization_.surface();
  const SurfacePoint at{before.triangle, before.to};
  if (before.triangle == after.triangle) return out.push_back(surface.original(at));
  for (const SurfacePoint& point : joint(surface, at, after.triangle)) out.push_back(surface.original(point));
}

void TracedPath::append_inner_points(const SurfacePoint& from, const SurfacePoint& to,
                                     std::vector<SurfacePoint>& out) const {
  std::vector<Piece> all = pieces();
  // An end in a face without area may have come out in a face beside it.
  if (!holds(discretization_.surface(), all.front().triangle, from))
    all.insert(all.begin(), {from.face, from.b, from.b});
  if (!holds(discretization_.surface(), all.back().triangle, to)) all.push_back({to.face, to.b, to.b});
  for (std::size_t i = 0; i + 1 < all.size(); ++i) append_joint(all[i], all[i + 1], out);
}

}  // namespace geodrome::aleksandrov
