// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/steiner_points.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome::aleksandrov {
namespace {

/// Radius of a vicinity over delta and the distance from the vertex to the border of its star.
constexpr double thin_share = 0.07, published_share = 1.0 / 7;
/// On weighted surfaces vicinities are smaller by this factor, for what is near sources.
constexpr double weighted_share = 0.5;
/// What the published steps and vicinities are proven for, between any points.
constexpr double published_limit = 0.4;
/// A point moved along its bisector by its whole distance from the vertex would be at the vertex.
constexpr double largest_step = 0.95;
/// Vicinities this small are rounding: about 1 is the mean edge.
constexpr double rounding = 1e-15;

}  // namespace

HalfAngle half_angle(const IntrinsicTriangulation::Face& face, int i) {
  const double cosine = std::sqrt((1 + face.cosine[i]) / 2);
  const double sine = face.cosine[i] > 0 ? face.sine[i] / (2 * cosine) : std::sqrt((1 - face.cosine[i]) / 2);
  return {face.cosine[i] > 0 ? cosine : face.sine[i] / (2 * sine), sine};
}

SteinerPlacement::SteinerPlacement(const IntrinsicTriangulation& triangulation, Placement placement, double delta,
                                   double thinning)
    : t_(triangulation), placement_(placement), radius_(triangulation.vertex_count(), infinity) {
  if (placement == Placement::published) delta = std::min(delta, published_limit);
  const double share = (placement == Placement::thin ? thin_share : published_share) * delta;
  std::vector<double> lightest(radius_.size(), infinity), heaviest(radius_.size(), 0);
  for (Index f = 0; f < t_.face_count(); ++f)
    for (int i = 0; i < 3; ++i) {
      const Index v = t_.face(f).vertex[i];
      radius_[v] = std::min(radius_[v], to_opposite_side(t_.face(f), i));
      lightest[v] = std::min(lightest[v], t_.weight(f)), heaviest[v] = std::max(heaviest[v], t_.weight(f));
    }
  const double vicinity = t_.weighted() ? weighted_share * share : share;
  for (std::size_t v = 0; v < radius_.size(); ++v)
    radius_[v] = std::max(rounding, vicinity * radius_[v] * lightest[v] / heaviest[v]);
  const double left = delta - 4 * share / (1 - 4 * share);
  step_ = thinning * (placement == Placement::thin ? std::sqrt(left * (2 + left)) : std::sqrt(delta / 2));
}

Bisector SteinerPlacement::at(Index h) const {
  const Index before = SurfaceMesh::previous(h);
  if (t_.next_on_edge(h) == h || t_.next_on_edge(before) == before) return {};
  const auto& face = t_.face(h / 3);
  const int i = static_cast<int>(h % 3);
  const auto [cosine, sine] = half_angle(face, i);
  const double p = face.length[i], q = face.length[(i + 2) % 3], whole = 2 * p * q * cosine / (p + q);
  const double radius = radius_[face.vertex[i]];
  if (!(whole > radius)) return {};
  if (placement_ == Placement::published) {
    const double first = radius * cosine, ratio = 1 + std::min(largest_step, step_ * sine);
    return {first, ratio, std::floor(std::log(whole / first) / std::log1p(ratio - 1)) + 1};
  }
  const double step = std::min(largest_step, step_ * sine / cosine), cells_wanted = std::log(whole / radius);
  const double cells = std::ceil(cells_wanted / (std::log1p(step) - std::log1p(-step)));
  const double ratio = std::exp(cells_wanted / cells);
  return {radius * 2 * ratio / (1 + ratio), ratio, cells};
}

double node_count(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement) {
  double nodes = triangulation.vertex_count();
  for (Index h = 0; h < 3 * triangulation.face_count(); ++h) nodes += placement.at(h).count;
  return nodes;
}

double edge_count(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement) {
  double edges = 0;
  const auto points = [&](Index h) { return placement.at(h).count + placement.at(SurfaceMesh::next(h)).count + 2; };
  for (Index h = 0; h < 3 * triangulation.face_count(); ++h)
    for (Index g = triangulation.next_on_edge(h); g != h; g = triangulation.next_on_edge(g))
      edges += points(h) * points(g);
  return edges;
}

}  // namespace geodrome::aleksandrov
