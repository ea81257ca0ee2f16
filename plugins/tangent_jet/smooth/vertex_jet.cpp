// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/vertex_jet.hpp"

#include <algorithm>

namespace geodrome {
namespace {

constexpr std::size_t fewest = 32, most = 512;

/// What a quartic leaves out of a smooth shape grows with the fifth power of the distance, so far points should count
/// little; noise is averaged best if all count.
FitRule rule_for(std::size_t count, double sigma) {
  return {count <= fewest ? 8.0 : count <= 2 * fewest ? 6.0 : 3.0, count <= fewest && sigma == 0};
}

/// By how much the residual of noise grows at most when the number of points is doubled: twice its spread.
double growth_of_noise(std::size_t count) { return 1.2 + 1800 / static_cast<double>(count * count); }
/// Residuals below this share of the radius are rounding: more points make no better fit.
constexpr double exact = 1e-9;

std::vector<Vec3> origins(const Tangents& tangents) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < tangents.plane.size(); ++i)
    if (tangents.state[i] != PointState::dropped) kept.push_back(tangents.plane[i].origin);
  return kept;
}

/// The quartic over its own tangent plane: heights along the normal of the surface are the least curved.
QuarticFit turned_fit(const std::vector<Vec3>& points, const std::vector<Neighbour>& around, const Vec3& base,
                      const Vec3& normal, const FitRule& rule) {
  const QuarticFit first = fit_quartic(points, around, base, normal, rule);
  return first.determined ? fit_quartic(points, around, base, first.quartic.normal(), rule) : first;
}

}  // namespace

JetPoints::JetPoints(const PointSample& sample, const Tangents& tangents)
    : places(origins(tangents)), sigma(tangents.sigma) {
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (tangents.state[i] == PointState::dropped) continue;
    raw.push_back(sample.points[i]);
    normal.push_back(tangents.plane[i].normal);
  }
}

QuarticFit vertex_jet(const JetPoints& points, const Vec3& vertex, std::vector<Neighbour>& around) {
  points.places.nearest(vertex, 1, around);
  const Vec3 normal = points.normal[around[0].index];
  const auto fit_to = [&](std::size_t count) {
    points.places.nearest_and_ties(vertex, count, around);
    return turned_fit(points.raw, around, vertex, normal, rule_for(count, points.sigma));
  };
  std::size_t count = fewest;
  QuarticFit best = fit_to(count);
  while (2 * count <= std::min(most, points.raw.size()) && !(best.residual <= exact * best.radius && best.determined)) {
    const QuarticFit larger = fit_to(2 * count);
    if (best.determined && larger.residual > growth_of_noise(count) * std::max(best.residual, points.sigma)) break;
    best = larger, count *= 2;
  }
  if (points.sigma == 0) return best;
  points.places.nearest_and_ties(vertex, count, around);
  const double residual = best.residual;
  best = turned_fit(points.places.points(), around, vertex, normal, rule_for(count, points.sigma));
  best.residual = residual;
  return best;
}

}  // namespace geodrome
