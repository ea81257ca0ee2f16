// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/propagation.hpp"

#include <algorithm>

#include "plugins/solver_aleksandrov/source_star.hpp"

namespace geodrome::aleksandrov {

Propagation::Propagation(const PackedMesh&, const Settings& discretization)
    : discretization_(discretization), search_(graph()) {}

void Propagation::begin(bool, double limit) {
  search_.begin();
  starts_.clear(), starts_at_.clear(), watched_.clear(), reached_.clear();
  limit_ = limit, margin_ = 0;
}

void Propagation::seed(const Source& source, Index number) {
  const PackedMesh& surface = discretization_->surface();
  const Index vertex = surface.mesh().vertex_at(source.at);
  if (vertex != no_index) {
    const Index node = surface.vertex_of_original(vertex);
    if (graph().weighted()) margin_ = std::max(margin_, scaled_limit * source_star(graph(), node).reach);
    return search_.seed(node, source.start, number);
  }
  if (graph().weighted())
    throw CapabilityError(
        "on a weighted surface sources must be vertices: between two other points near a vertex the "
        "factor would not hold",
        "name vertices as sources, or leave the weights out");

  struct Seeds {
    GraphSearch& search;
    const SteinerGraph& graph;
    double start;
    Index number;
    void via(Index, Point2, Index) const {}
    void vertex(Index corner, double length) const { point(graph.corner(corner).vertex, length); }
    bool wants(Index, double) const { return true; }
    void point(Index node, double length) const { search.seed(node, start + length, number); }
    void strip(const SteinerGraph::Strip& s) const {
      for (Index node = s.first; node < s.last; ++node) point(node, SteinerGraph::length(s, graph.distances()[node]));
    }
  };
  graph().for_each_name(discretization_->located(surface.inner(source.at)), [&](const SurfacePoint& name) {
    for (Index i = 0; i < 3; ++i)
      starts_at_.emplace_back(graph().corner(3 * name.face + i).vertex, static_cast<Index>(starts_.size()));
    starts_.push_back({name, source.start, number, surface.inner(source.at)});
    graph().for_each_edge(name, Seeds{search_, graph(), source.start, number});
  });
}

/// Those that have a corner in common with the face of a place.
std::vector<Index> Propagation::starts_near(const SurfacePoint& at) const {
  std::vector<Index> near;
  for (Index i = 0; i < 3; ++i) {
    const std::pair<Index, Index> first{graph().corner(3 * at.face + i).vertex, 0};
    for (auto s = std::lower_bound(starts_at_.begin(), starts_at_.end(), first);
         s != starts_at_.end() && s->first == first.first; ++s)
      near.push_back(s->second);
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

void Propagation::look_at_watched() {
  for (Watched& watched : watched_) {
    const Way way = way_to(watched.at, watched.distance);
    if (way.distance < watched.distance) watched.distance = way.distance, watched.source = way.source;
  }
}

void Propagation::finish() {
  look_at_watched();
  const auto vertices = static_cast<Index>(discretization_->surface().vertex_count());
  for (const Index node : search_.labels().touched())
    if (node < vertices) reached_.push_back(node);
}

Propagation::Way Propagation::way_to(const SurfacePoint& inner, double best) const {
  Way way;
  way.distance = best;
  graph().for_each_name(discretization_->located(inner), [&](const SurfacePoint& name) {
    through_nodes(name, way);
    if (graph().weighted())
      around_sources(name, way);
    else
      straight(name, way);
  });
  way.flat = inner;
  return way.source == no_index ? Way{} : way;
}

void Propagation::through_nodes(const SurfacePoint& name, Way& way) const {
  struct Nearest {
    const SteinerGraph& graph;
    const NodeLabels& labels;
    Way& way;
    const SurfacePoint& name;

    void via(Index, Point2, Index) const {}
    void vertex(Index corner, double length) const { point(graph.corner(corner).vertex, length); }
    void strip(const SteinerGraph::Strip& s) const {
      for (Index node = s.first; node < s.last; ++node)
        if (labels.distance(node) < way.distance) point(node, SteinerGraph::length(s, graph.distances()[node]));
    }
    bool wants(Index node, double least) const { return labels.distance(node) + least < way.distance; }
    void point(Index node, double length) const {
      const double distance = labels.distance(node) + length;
      if (distance < way.distance) way = {distance, labels.source(node), node, no_index, name, {}};
    }
  };
  graph().for_each_edge(name, Nearest{graph(), search_.labels(), way, name});
}

void Propagation::straight(const SurfacePoint& name, Way& way) const {
  for (const Index i : starts_near(name)) {
    const double distance = starts_[i].distance + direct_way(graph(), starts_[i].at, name).distance;
    if (distance < way.distance) way = {distance, starts_[i].source, no_index, i, name, {}};
  }
}

/// On a weighted surface all sources are vertices.
void Propagation::around_sources(const SurfacePoint& name, Way& way) const {
  const NodeLabels& labels = search_.labels();
  for (Index i = 0; i < 3; ++i) {
    const Index vertex = graph().corner(3 * name.face + i).vertex;
    if (labels.source(vertex) != no_index && labels.previous(vertex) == no_index) around_source(name, i, way);
  }
}

/// By a way from the source at corner `i` to a place farther out in the same direction.
void Propagation::around_source(const SurfacePoint& name, Index i, Way& way) const {
  const Index corner = 3 * name.face + i, vertex = graph().corner(corner).vertex;
  const auto [width, reach] = source_star(graph(), vertex);
  const double start = search_.labels().distance(vertex), away = length(graph().in_frame(corner, name.b));
  if (!(away > 0) || way.distance - start >= surely_far * reach) return;
  double out = scaled_limit / 2 * width;
  for (; out > away && out * graph().weight(name.face) >= far_enough * reach; out /= scale_step) {
    const double scale = out / away;
    Way larger;
    larger.distance = start + std::min(scale * (way.distance - start), scaled_limit * reach);
    through_nodes(scaled(name, i, scale), larger);
    if (larger.source != search_.labels().source(vertex)) continue;
    larger.distance = start + (larger.distance - start) / scale;
    if (larger.distance < way.distance) way = larger, way.around = vertex, way.scale = scale;
  }
}

void Propagation::trace(const Way& way, std::vector<SurfacePoint>& out) const {
  TracedPath path(*discretization_);
  if (way.start != no_index) {
    path.direct(way.at, starts_[way.start].at);
    return path.append_inner_points(way.flat, starts_[way.start].flat, out);
  }
  path.to_node(way.at, way.node);
  const SurfacePoint end = trace_nodes(way.node, path);
  if (way.around != no_index) path.shrink(way.around, way.scale);
  path.append_inner_points(way.flat, end, out);
}

void Propagation::trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const {
  TracedPath path(*discretization_);
  const SurfacePoint end = trace_nodes(vertex, path);
  if (path.empty()) return;
  const PackedMesh& surface = discretization_->surface();
  const SurfacePoint start = surface.mesh().at_vertex(surface.original_vertex(vertex));
  out.push_back(start);
  path.append_inner_points(surface.inner(start), end, out);
}

/// From a node to its source, whose name in the flat surface is returned.
SurfacePoint Propagation::trace_nodes(Index node, TracedPath& path) const {
  const NodeLabels& labels = search_.labels();
  for (Index next = labels.previous(node); next != no_index; node = next, next = labels.previous(node))
    path.between_nodes(node, next);
  const Start* nearest = nullptr;
  double best = infinity;
  for (const Start& start : starts_) {
    if (start.source != labels.source(node)) continue;
    const double distance = start.distance + path.length_to_node(start.at, node);
    if (distance < best) best = distance, nearest = &start;
  }
  if (nearest) {
    path.from_node(node, nearest->at);
    return nearest->flat;
  }
  const PackedMesh& surface = discretization_->surface();
  return surface.inner(surface.mesh().at_vertex(surface.original_vertex(node)));
}

std::array<Counter, 5> Propagation::counters() const {
  const std::uint64_t vertices = discretization_->surface().vertex_count();
  return {{{"largest_steiner_points", graph().node_count() - graph().vertex_count()},
           {"largest_inserted_vertices", graph().vertex_count() - vertices},
           {"settled_nodes", search_.labels().touched().size()},
           {"graph_edges", search_.edges_compared()},
           {"largest_search_bytes", search_.bytes() + watched_.capacity() * sizeof(Watched)}}};
}

}  // namespace geodrome::aleksandrov
