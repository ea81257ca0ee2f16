// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/steiner_graph.hpp"

namespace geodrome::aleksandrov {
SteinerGraph::SteinerGraph(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement)
    : corners_(3 * triangulation.face_count()), first_corner_(triangulation.vertex_count() + 1, 0) {
  for (Index h = 0; h < corners_.size(); ++h) {
    const auto& face = triangulation.face(h / 3);
    const HalfAngle half = half_angle(face, static_cast<int>(h % 3));
    corners_[h] = {
        triangulation.length(h),       half.cosine, half.sine, triangulation.apex(h),   triangulation.from(h),
        triangulation.next_on_edge(h), 0,           0,         triangulation.forward(h)};
    ++first_corner_[corners_[h].vertex + 1];
  }
  for (std::size_t v = 1; v < first_corner_.size(); ++v) first_corner_[v] += first_corner_[v - 1];
  corners_at_.resize(corners_.size());
  std::vector<Index> end = first_corner_;
  for (Index h = 0; h < corners_.size(); ++h) corners_at_[end[corners_[h].vertex]++] = h;
  add_points(triangulation, placement);
  if (triangulation.weighted()) weigh(triangulation);
}

/// An edge is as cheap as the cheapest of its faces.
void SteinerGraph::weigh(const IntrinsicTriangulation& triangulation) {
  for (Index f = 0; f < face_count(); ++f) weights_.push_back(triangulation.weight(f));
  for (Index h = 0; h < corners_.size(); ++h) {
    double lightest = weights_[h / 3];
    for (Index g = corners_[h].next_on_edge; g != h; g = corners_[g].next_on_edge)
      lightest = std::min(lightest, weights_[g / 3]);
    edge_weights_.push_back(lightest);
  }
}

Crossing SteinerGraph::crossing(Index h, Point2 p, Index g, Point2 q) const {
  const Point2 below = unfolded(h, g, q);
  const double weight = edge_weight(h);
  if (weighted() && (weight != weights_[h / 3] || weight != weights_[g / 3]))
    return cheapest_crossing(p, weights_[h / 3], below, weights_[g / 3], weight);
  const double drop = p.y - below.y, x = drop > 0 ? p.x + (below.x - p.x) * (p.y / drop) : p.x;
  return {weight * aleksandrov::length(p - below), x, x};
}

void SteinerGraph::add_points(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement) {
  std::vector<Bisector> bisectors(corners_.size());
  double nodes = triangulation.vertex_count();
  for (Index h = 0; h < corners_.size(); ++h) nodes += (bisectors[h] = placement.at(h)).count;
  distance_.reserve(static_cast<std::size_t>(nodes));
  distance_.assign(triangulation.vertex_count(), 0);
  for (Index h = 0; h < corners_.size(); ++h) {
    corners_[h].first = node_count();
    double at = bisectors[h].first;
    for (double k = 0; k < bisectors[h].count; ++k, at *= bisectors[h].ratio) {
      distance_.push_back(at);
      corner_of_.push_back(h);
    }
    corners_[h].last = node_count();
  }
}

Point2 SteinerGraph::in_frame(Index h, Index node) const {
  const Index own = corner_of(node);
  const double t = distance_[node];
  Point2 p{t * corners_[own].cosine, t * corners_[own].sine};
  for (Index at = own; at != h; at = SurfaceMesh::next(at)) {
    const Corner &here = corners_[at], &next = corners_[SurfaceMesh::next(at)];
    const Point2 end{here.length, 0}, along = (1 / next.length) * (here.apex - end);
    p = {dot(along, p - end), cross(along, p - end)};
  }
  return p;
}

Point2 SteinerGraph::in_frame(Index h, const Barycentric& b) const {
  return place({Point2{0, 0}, Point2{corners_[h].length, 0}, corners_[h].apex},
               {b[h % 3], b[(h + 1) % 3], b[(h + 2) % 3]});
}

Barycentric SteinerGraph::coordinates(Index h, Point2 p) const {
  const Barycentric turned = barycentric({Point2{0, 0}, Point2{corners_[h].length, 0}, corners_[h].apex}, p);
  Barycentric b;
  for (Index i = 0; i < 3; ++i) b[(h + i) % 3] = turned[i];
  return b;
}

std::size_t SteinerGraph::bytes() const {
  return corners_.size() * sizeof(Corner) + distance_.size() * sizeof(double) +
         (corner_of_.size() + first_corner_.size() + corners_at_.size()) * sizeof(Index) +
         (weights_.size() + edge_weights_.size()) * sizeof(double);
}

}  // namespace geodrome::aleksandrov
