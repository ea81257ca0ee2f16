// SPDX-License-Identifier: MIT
#pragma once

#include <boost/graph/breadth_first_search.hpp>
#include <cstdint>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/solver_kit/indexed_heap.hpp"
#include "plugins/solver_aleksandrov/steiner_graph.hpp"

namespace geodrome::aleksandrov {

/// The shortest ways found so far to the nodes of a Steiner graph. Forgetting costs what was reached.
class NodeLabels {
 public:
  explicit NodeLabels(Index nodes) : distance_(nodes, infinity), source_(nodes, no_index), previous_(nodes, no_index) {}

  double distance(Index node) const { return distance_[node]; }  ///< infinity where there is none
  const double* distances() const { return distance_.data(); }
  Index source(Index node) const { return source_[node]; }
  Index previous(Index node) const { return previous_[node]; }  ///< no_index where the way starts
  const std::vector<Index>& touched() const { return touched_; }

  /// Whether a way would be shorter, or as short and from a lower source.
  bool improves(Index node, double distance, Index source) const {
    return distance < distance_[node] || (distance == distance_[node] && source < source_[node]);
  }
  void set(Index node, double distance, Index source, Index previous) {
    if (source_[node] == no_index) touched_.push_back(node);
    distance_[node] = distance, source_[node] = source, previous_[node] = previous;
  }
  void clear() {
    for (const Index node : touched_) {
      distance_[node] = infinity;
      source_[node] = previous_[node] = no_index;
    }
    touched_.clear();
  }
  std::size_t bytes() const {
    return distance_.size() * (sizeof(double) + 2 * sizeof(Index)) + touched_.capacity() * sizeof(Index);
  }

 private:
  std::vector<double> distance_;
  std::vector<Index> source_, previous_, touched_;
};

/// The Steiner graph as Boost.Graph sees it during a search: edges out of a node are made when they are asked for, and
/// only those that shorten the way to their end. All others would be looked at and dropped.
class ImprovingEdges {
 public:
  struct Edge {
    Index from, to;
    double distance;  ///< of `to`, through `from`

    friend bool operator==(const Edge&, const Edge&) = default;
  };
  using vertex_descriptor = Index;
  using edge_descriptor = Edge;
  using out_edge_iterator = const Edge*;
  using degree_size_type = std::size_t;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  struct traversal_category : boost::incidence_graph_tag {};
  static Index null_vertex() { return no_index; }

  ImprovingEdges(const SteinerGraph& graph, const NodeLabels& labels) : graph_(graph), labels_(labels) {}

  /// Valid until the next call.
  std::pair<const Edge*, const Edge*> edges_from(Index node) const;
  /// Edges that were compared so far.
  std::uint64_t compared() const { return compared_; }
  void reset_count() { compared_ = 0; }

 private:
  const SteinerGraph& graph_;
  const NodeLabels& labels_;
  mutable std::vector<Edge> found_;
  mutable std::vector<Index> near_;
  mutable std::uint64_t compared_ = 0;
};

inline auto out_edges(Index node, const ImprovingEdges& graph) { return graph.edges_from(node); }
inline std::size_t out_degree(Index node, const ImprovingEdges& graph) {
  const auto [begin, end] = graph.edges_from(node);
  return static_cast<std::size_t>(end - begin);
}
inline Index source(const ImprovingEdges::Edge& edge, const ImprovingEdges&) { return edge.from; }
inline Index target(const ImprovingEdges::Edge& edge, const ImprovingEdges&) { return edge.to; }

/// Dijkstra's search over the Steiner graph by Boost.Graph. Used again and again: a run costs what it reaches. Of two
/// ways of equal length the one from the lower source stays.
class GraphSearch {
 public:
  explicit GraphSearch(const SteinerGraph& graph)
      : labels_(graph.node_count()),
        edges_(graph, labels_),
        color_(graph.node_count(), boost::white_color),
        queue_(graph.node_count()) {}
  GraphSearch(const GraphSearch&) = delete;
  GraphSearch& operator=(const GraphSearch&) = delete;

  /// Forgets the last run, even one that was stopped.
  void begin();
  /// Offers a node a way from a source that is not through another node.
  void seed(Index node, double distance, Index source);

  /// Settles all nodes up to `limit`. `lower_limit()` is called once in `steps_a_poll` nodes, or more often where nodes
  /// see many others, and may give a lower one. May throw Cancelled.
  template <class LowerLimit>
  void run(const RunContext& context, double limit, LowerLimit&& lower_limit);
  static constexpr std::size_t steps_a_poll = 1024;
  /// Some milliseconds; on weighted surfaces a tenth of a second.
  static constexpr std::uint64_t edges_a_poll = 1000000;

  /// Final up to the limit of the run; lengths of some ways beyond.
  const NodeLabels& labels() const { return labels_; }
  std::uint64_t edges_compared() const { return edges_.compared(); }
  std::size_t bytes() const { return labels_.bytes() + color_.size() * sizeof(color_[0]) + queue_.bytes(); }

 private:
  /// What breadth_first_visit takes its next node from: the nearest, until the limit.
  struct Nearest {
    IndexedHeap& heap;
    const NodeLabels& labels;
    const double& limit;

    bool empty() const { return heap.empty() || heap.top_key() > limit; }
    Index top() const { return heap.top(); }
    void pop() { heap.pop(); }
    void push(Index node) { heap.push(node, labels.distance(node)); }
  };
  template <class Poll>
  class Relax;

  NodeLabels labels_;
  ImprovingEdges edges_;
  std::vector<boost::default_color_type> color_;
  IndexedHeap queue_;
  std::vector<Index> seeds_;
};

/// Sets labels as edges are met. A node whose label is lowered at the same distance, by a lower source, keeps its
/// place.
template <class Poll>
class GraphSearch::Relax : public boost::default_bfs_visitor {
 public:
  Relax(NodeLabels& labels, IndexedHeap& queue, Poll& poll) : labels_(labels), queue_(queue), poll_(poll) {}

  void examine_vertex(Index, const ImprovingEdges&) { poll_(); }
  void tree_edge(const ImprovingEdges::Edge& edge, const ImprovingEdges&) { relax(edge); }
  void gray_target(const ImprovingEdges::Edge& edge, const ImprovingEdges&) {
    if (relax(edge)) queue_.push(edge.to, edge.distance);
  }

 private:
  bool relax(const ImprovingEdges::Edge& edge) {
    const Index source = labels_.source(edge.from);
    if (!labels_.improves(edge.to, edge.distance, source)) return false;
    labels_.set(edge.to, edge.distance, source, edge.from);
    return true;
  }

  NodeLabels& labels_;
  IndexedHeap& queue_;
  Poll& poll_;
};

template <class LowerLimit>
void GraphSearch::run(const RunContext& context, double limit, LowerLimit&& lower_limit) {
  std::size_t step = 0;
  std::uint64_t polled = 0;  // edges compared until then
  auto poll = [&] {
    if (step++ % steps_a_poll != 0 && edges_.compared() - polled < edges_a_poll) return;
    polled = edges_.compared();
    context.throw_if_cancelled();
    limit = std::min(limit, lower_limit());
  };
  Nearest nearest{queue_, labels_, limit};
  boost::breadth_first_visit(
      edges_, seeds_.begin(), seeds_.end(), nearest, Relax<decltype(poll)>(labels_, queue_, poll),
      boost::make_iterator_property_map(color_.data(), boost::typed_identity_property_map<Index>()));
}

}  // namespace geodrome::aleksandrov
