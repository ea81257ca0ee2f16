// SPDX-License-Identifier: MIT
#include "solver_aleksandrov/propagation.hpp"

namespace geodrome::aleksandrov {

Propagation::Propagation(const FlatSurface&, const Settings& discretization)
    : discretization_(discretization), search_(graph()), labels_(search_.labels()) {}

void Propagation::begin(bool, double limit) {
  search_.begin();
  starts_.clear(), watched_.clear(), labels_.touched_.clear();
  limit_ = limit;
}

void Propagation::seed(const Source& source, Index number) {
  const FlatSurface& surface = discretization_->surface();
  const Index vertex = surface.mesh().vertex_at(source.at);
  if (vertex != no_index) return search_.seed(surface.vertex_of_original(vertex), source.start, number);

  struct Seeds {
    GraphSearch& search;
    const SteinerGraph& graph;
    double start;
    Index number;
    void via(Index, Point2, Index) const {}
    void vertex(Index corner, double length) const { search.seed(graph.corner(corner).vertex, start + length, number); }
    void strip(const SteinerGraph::Strip& s) const {
      for (Index node = s.first; node < s.last; ++node)
        search.seed(node, start + SteinerGraph::length(s, graph.distances()[node]), number);
    }
  };
  graph().for_each_name(discretization_->located(surface.inner(source.at)), [&](const SurfacePoint& name) {
    starts_.push_back({name, source.start, number});
    graph().for_each_edge(name, Seeds{search_, graph(), source.start, number});
  });
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
    if (node < vertices) labels_.touched_.push_back(node);
}

Propagation::Way Propagation::way_to(const SurfacePoint& inner, double best) const {
  struct Nearest {
    const SteinerGraph& graph;
    const NodeLabels& labels;
    Way& way;
    const SurfacePoint* name;

    void via(Index, Point2, Index) const {}
    void vertex(Index corner, double length) const { improve(graph.corner(corner).vertex, length); }
    void strip(const SteinerGraph::Strip& s) const {
      for (Index node = s.first; node < s.last; ++node)
        if (labels.distance(node) < way.distance) improve(node, SteinerGraph::length(s, graph.distances()[node]));
    }
    void improve(Index node, double length) const {
      const double distance = labels.distance(node) + length;
      if (distance < way.distance) way = {distance, labels.source(node), node, no_index, *name};
    }
  };
  Way way;
  way.distance = best;
  graph().for_each_name(discretization_->located(inner), [&](const SurfacePoint& name) {
    graph().for_each_edge(name, Nearest{graph(), search_.labels(), way, &name});
    for (Index i = 0; i < starts_.size(); ++i) {
      const double distance = starts_[i].distance + direct_way(graph(), starts_[i].at, name).distance;
      if (distance < way.distance) way = {distance, starts_[i].source, no_index, i, name};
    }
  });
  return way.source == no_index ? Way{} : way;
}

void Propagation::trace(const Way& way, std::vector<SurfacePoint>& out) const {
  TracedPath path(*discretization_);
  if (way.start != no_index) {
    path.direct(way.at, starts_[way.start].at);
  } else {
    path.to_node(way.at, way.node);
    trace_nodes(way.node, path);
  }
  path.append_inner_points(out);
}

void Propagation::trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const {
  TracedPath path(*discretization_);
  if (!trace_nodes(vertex, path)) return;
  const FlatSurface& surface = discretization_->surface();
  out.push_back(surface.mesh().at_vertex(surface.original_vertex(vertex)));
  path.append_inner_points(out);
}

/// From a node to its source; false if the node is at its source.
bool Propagation::trace_nodes(Index node, TracedPath& path) const {
  const NodeLabels& labels = search_.labels();
  const Index first = node;
  for (Index next = labels.previous(node); next != no_index; node = next, next = labels.previous(node))
    path.between_nodes(node, next);
  const Start* nearest = nullptr;
  double best = std::numeric_limits<double>::infinity();
  for (const Start& start : starts_) {
    if (start.source != labels.source(node)) continue;
    const double distance = start.distance + path.length_to_node(start.at, node);
    if (distance < best) best = distance, nearest = &start;
  }
  if (!nearest) return node != first;
  path.from_node(node, nearest->at);
  return true;
}

std::array<Counter, 5> Propagation::counters() const {
  const std::uint64_t vertices = discretization_->surface().vertex_count();
  return {{{"largest_Steiner_points", graph().node_count() - graph().vertex_count()},
           {"largest_inserted_vertices", graph().vertex_count() - vertices},
           {"settled nodes", search_.labels().touched().size()},
           {"graph edges", search_.edges_compared()},
           {"largest_search_bytes", search_.bytes() + watched_.capacity() * sizeof(Watched)}}};
}

}  // namespace geodrome::aleksandrov
