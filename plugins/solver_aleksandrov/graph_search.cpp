// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/graph_search.hpp"

#include <cmath>

#include "plugins/solver_aleksandrov/strip_scan.hpp"

namespace geodrome::aleksandrov {

/// Strips are compared by squares: a root only for what is shorter. A tie counts as shorter, so that a lower source can
/// take it.
std::pair<const ImprovingEdges::Edge*, const ImprovingEdges::Edge*> ImprovingEdges::edges_from(Index node) const {
  struct Reader {
    const ImprovingEdges& view;
    Index node;
    double base;
    const double *t, *best;

    void via(Index, Point2, Index) const {}
    void vertex(Index corner, double length) const { point(view.graph_.corner(corner).vertex, length); }
    bool wants(Index to, double least) const { return base + least <= best[to]; }
    void point(Index to, double length) const {
      ++view.compared_;
      if (base + length <= best[to]) view.found_.push_back({node, to, base + length});
    }
    void strip(const SteinerGraph::Strip& s) const {
      view.compared_ += s.last - s.first;
      view.near_.clear();
      scan_strip(t + s.first, best + s.first, s.last - s.first, base, s.x, s.y, s.dx, s.dy, s.first, view.near_);
      for (const Index to : view.near_) {
        const double px = s.x - t[to] * s.dx, py = s.y - t[to] * s.dy;
        view.found_.push_back({node, to, base + std::sqrt(px * px + py * py)});
      }
    }
  };
  found_.clear();
  graph_.for_each_edge(node, Reader{*this, node, labels_.distance(node), graph_.distances(), labels_.distances()});
  return {found_.data(), found_.data() + found_.size()};
}

void GraphSearch::begin() {
  for (const Index node : labels_.touched()) color_[node] = boost::white_color;
  labels_.clear();
  queue_.clear();
  seeds_.clear();
  edges_.reset_count();
}

void GraphSearch::seed(Index node, double distance, Index source) {
  if (!labels_.improves(node, distance, source)) return;
  if (labels_.source(node) == no_index) seeds_.push_back(node);
  labels_.set(node, distance, source, no_index);
}

}  // namespace geodrome::aleksandrov
