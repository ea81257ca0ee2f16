// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/labelling.hpp"

#include <algorithm>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/property_map.hpp>
#include <cmath>
#include <utility>

namespace geodrome {
namespace {

/// Costs are multiples of 1 / scale.
constexpr double scale = 10'000;

/// Of a facet, by the number of its corners' stars that have it.
constexpr std::uint16_t facet_cost[] = {4000, 2000, 1000, 0};

/// The stars that have a facet say on which sides of it its two cells are: what that adds to their scores.
constexpr std::int32_t facet_evidence[] = {0, 1000, 3000, 6000};

/// Volume over the cube of the longest edge below which a cell lies in the surface, and so on neither side of it.
constexpr double flat_cell = 1e-5;

/// Cells over a shallow hollow, or under a crease where normals are averaged, have small scores of either sign: no
/// evidence.
constexpr double dead_zone = 0.3;

double score(const Tetrahedra::Cell& cell, std::span<const Vec3> points, std::span<const Vec3> normals) {
  const Vec3 &a = points[cell[0]], &b = points[cell[1]], &c = points[cell[2]], &d = points[cell[3]];
  const double volume = dot(b - a, cross(c - a, d - a)) / 6;
  const double longest = std::sqrt(std::max({squared_distance(a, b), squared_distance(a, c), squared_distance(a, d),
                                             squared_distance(b, c), squared_distance(b, d), squared_distance(c, d)}));
  if (!(std::abs(volume) >= flat_cell * longest * longest * longest)) return 0;
  const Vec3 centre = (a + b + c + d) / 4;
  double sum = 0;
  for (const Index p : cell) {
    const Vec3 way = centre - points[p];
    sum += dot(way, normals[p]) / norm(way);
  }
  const double mean = sum / 4;
  return mean > 0 ? std::max(0.0, mean - dead_zone) : std::min(0.0, mean + dead_zone);
}

/// 1 if the normals of all three corners look to the facet's front, -1 if to its back, 0 if they do not agree.
int side_of_stars(const OrientedPiece& piece, const Triangle& facet) {
  const Vec3 &a = piece.points[facet[0]], &b = piece.points[facet[1]], &c = piece.points[facet[2]];
  const Vec3 front = cross(b - a, c - a);
  int sum = 0;
  for (const Index p : facet) sum += dot(front, piece.normals[p]) > 0 ? 1 : -1;
  return sum / 3;
}

/// A flow network with a node per cell, then source and sink; every edge is there both ways.
class Network {
 public:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                   boost::no_property, Index, Index>;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;

  Network(const Tetrahedra& tetrahedra, const CutCosts& costs);
  Labels minimal_cut();

 private:
  void add(Index from, Index to, std::int32_t there, std::int32_t back) {
    arcs_.push_back({from, to, there, static_cast<Index>(arcs_.size() + 1)});
    arcs_.push_back({to, from, back, static_cast<Index>(arcs_.size() - 1)});
  }
  void build();

  struct Arc {
    Index from, to;
    std::int32_t capacity;
    Index reverse;
  };

  Index cells_;
  std::vector<Arc> arcs_;
  Graph graph_;
  std::vector<std::int32_t> capacity_;
  std::vector<Edge> reverse_;
};

Network::Network(const Tetrahedra& tetrahedra, const CutCosts& costs) : cells_(static_cast<Index>(tetrahedra.size())) {
  const Index source = cells_, sink = cells_ + 1;
  for (Index c = 0; c < cells_; ++c) {
    if (tetrahedra.infinite(c)) continue;
    std::int32_t outside = costs.inside[c];
    for (int i = 0; i < 4; ++i) {
      const Index other = tetrahedra.neighbours[c][i];
      if (tetrahedra.infinite(other))
        outside += costs.cut[c][i];
      else if (c < other)
        add(c, other, costs.cut[c][i], costs.cut[c][i]);
    }
    if (outside > 0) add(source, c, outside, 0);
    if (outside < 0) add(c, sink, -outside, 0);
  }
  build();
}

/// Sorts the arcs by their start, as the graph wants them.
void Network::build() {
  std::vector<Index> place(arcs_.size()), next(cells_ + 3, 0);
  for (const Arc& arc : arcs_) ++next[arc.from + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  for (std::size_t i = 0; i < arcs_.size(); ++i) place[i] = next[arcs_[i].from]++;
  std::vector<std::pair<Index, Index>> ends(arcs_.size());
  std::vector<Index> reverse(arcs_.size());
  capacity_.resize(arcs_.size());
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    ends[place[i]] = {arcs_[i].from, arcs_[i].to};
    capacity_[place[i]] = arcs_[i].capacity;
    reverse[place[i]] = place[arcs_[i].reverse];
  }
  arcs_ = {};
  graph_ = Graph(boost::edges_are_sorted, ends.begin(), ends.end(), cells_ + 2);
  const auto [first, last] = boost::edges(graph_);
  const std::vector<Edge> edges(first, last);
  reverse_.reserve(edges.size());
  for (const Index r : reverse) reverse_.push_back(edges[r]);
}

Labels Network::minimal_cut() {
  const std::size_t nodes = cells_ + 2;
  std::vector<std::int32_t> residual(capacity_.size());
  std::vector<Edge> parent(nodes);
  std::vector<boost::default_color_type> color(nodes);
  std::vector<std::int32_t> length(nodes);
  const auto edge_index = boost::get(boost::edge_index, graph_);
  const auto vertex_index = boost::get(boost::vertex_index, graph_);
  boost::boykov_kolmogorov_max_flow(graph_, boost::make_iterator_property_map(capacity_.begin(), edge_index),
                                    boost::make_iterator_property_map(residual.begin(), edge_index),
                                    boost::make_iterator_property_map(reverse_.begin(), edge_index),
                                    boost::make_iterator_property_map(parent.begin(), vertex_index),
                                    boost::make_iterator_property_map(color.begin(), vertex_index),
                                    boost::make_iterator_property_map(length.begin(), vertex_index), vertex_index,
                                    static_cast<Index>(cells_), static_cast<Index>(cells_ + 1));
  Labels inside(cells_);
  for (Index c = 0; c < cells_; ++c) inside[c] = color[c] != boost::black_color;
  return inside;
}

}  // namespace

CutCosts cut_costs(const Tetrahedra& tetrahedra, const OrientedPiece& piece, const PlanarStars& stars) {
  CutCosts costs;
  costs.inside.resize(tetrahedra.size(), 0);
  costs.cut.resize(tetrahedra.size());
  for (Index c = 0; c < tetrahedra.size(); ++c) {
    if (tetrahedra.infinite(c)) continue;
    costs.inside[c] +=
        static_cast<std::int32_t>(std::lround(scale * score(tetrahedra.corners[c], piece.points, piece.normals)));
    for (int i = 0; i < 4; ++i) {
      const Index other = tetrahedra.neighbours[c][i];
      if (other < c && !tetrahedra.infinite(other)) {
        costs.cut[c][i] = costs.cut[other][tetrahedra.mirror(c, i)];
        continue;
      }
      const auto [a, b, d] = facet_of(tetrahedra.corners[c], i);
      const int holders = stars.holders({piece.kept[a], piece.kept[b], piece.kept[d]});
      costs.cut[c][i] = facet_cost[holders];
      const std::int32_t evidence = side_of_stars(piece, {a, b, d}) * facet_evidence[holders];
      costs.inside[c] -= evidence;
      costs.inside[other] += evidence;
    }
  }
  return costs;
}

Labels cheapest_labels(const Tetrahedra& tetrahedra, const CutCosts& costs) {
  Labels inside = Network(tetrahedra, costs).minimal_cut();
  for (Index c = 0; c < tetrahedra.size(); ++c)
    if (tetrahedra.infinite(c)) inside[c] = 0;
  return inside;
}

}  // namespace geodrome
