// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <utility>

#include "engine/input/ear_clipping.hpp"

namespace geodrome::input {
namespace {

struct Edge {
  GridPoint from, to;
  friend constexpr auto operator<=>(const Edge&, const Edge&) = default;
};

/// The edges of a walk by how often they are passed.
struct WalkEdges {
  std::vector<Edge> all;  ///< each once, from its smaller end to its larger
  std::vector<Edge> once;
  bool sound = true;  ///< none is passed twice in one direction, or three times
};

WalkEdges edges_of(std::span<const GridPoint> walk) {
  std::map<Edge, int> passed;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const GridPoint &from = walk[i], &to = walk[(i + 1) % walk.size()];
    if (from != to) ++passed[{from, to}];
  }
  WalkEdges edges;
  for (const auto& [edge, times] : passed) {
    const bool is_bridge = passed.contains({edge.to, edge.from});
    if (times > 1) edges.sound = false;
    if (!is_bridge) edges.once.push_back(edge);
    if (!is_bridge || edge.from < edge.to)
      edges.all.push_back({std::min(edge.from, edge.to), std::max(edge.from, edge.to)});
  }
  return edges;
}

int side(const Edge& edge, const GridPoint& p) {
  const WideInteger area = doubled_area(edge.from, edge.to, p);
  return (area > 0) - (area < 0);
}

/// `p` lies on the edge, its ends not counted. Precondition: its side is 0. Ends are in order.
bool is_between(const Edge& edge, const GridPoint& p) { return edge.from < p && p < edge.to; }

/// Precondition: the edges differ.
bool cross_or_touch(const Edge& a, const Edge& b) {
  const int from = side(a, b.from), to = side(a, b.to);
  if ((from == 0 && is_between(a, b.from)) || (to == 0 && is_between(a, b.to))) return true;
  const int other_from = side(b, a.from), other_to = side(b, a.to);
  if ((other_from == 0 && is_between(b, a.from)) || (other_to == 0 && is_between(b, a.to))) return true;
  return from * to < 0 && other_from * other_to < 0;
}

bool any_cross(std::vector<Edge> edges) {
  std::ranges::sort(edges);  // by the smaller x
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].from.x <= edges[i].to.x; ++j)
      if (cross_or_touch(edges[i], edges[j])) return true;
  return false;
}

/// The edges passed once are closed outlines that share no corner, and one of them alone turns left.
bool one_outline_and_holes(const std::vector<Edge>& edges) {
  std::map<GridPoint, GridPoint> next;
  for (const Edge& edge : edges)
    if (!next.emplace(edge.from, edge.to).second) return false;
  int outlines = 0;
  while (!next.empty()) {
    const GridPoint start = next.begin()->first;
    WideInteger area = 0;
    for (GridPoint at = start;;) {
      const auto found = next.find(at);
      if (found == next.end()) break;
      area += doubled_area(start, at, found->second);
      at = found->second;
      next.erase(found);
    }
    if (area == 0) return false;
    if (area > 0) ++outlines;
  }
  return outlines == 1;
}

}  // namespace

bool bounds_one_region(std::span<const GridPoint> walk) {
  const WalkEdges edges = edges_of(walk);
  return edges.sound && one_outline_and_holes(edges.once) && !any_cross(edges.all);
}

}  // namespace geodrome::input
