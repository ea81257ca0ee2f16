// SPDX-License-Identifier: MIT
#include <iterator>

#include "engine/checks/gauge.hpp"
#include "engine/input/point_tree.hpp"

namespace geodrome {

namespace {

/// As many as a vertex of a triangulation has on average.
constexpr unsigned neighbours = 6;
/// Share of the kept points. Of pipes whose slit is too narrow for the sample, and so joined, a quarter is on the rim:
/// what phi is there tells of the slit.
constexpr double most_on_rim = 0.1;

/// Calls visit(point, phi over the radius of curvature) for both ends of every two kept points that are neighbours and
/// wanted.
template <class Wanted, class Visit>
void visit_turns(const SampleStages& stages, const Wanted& wanted, const Visit& visit) {
  const std::vector<Vec3>& points = stages.smoothed.points;
  const std::vector<TangentPlane>& planes = stages.tangents.plane;
  std::vector<input::PlacedPoint> entries, near;
  for (const Index i : stages.kept) entries.emplace_back(input::tree_point(points[i]), i);
  const input::PointTree tree(entries);
  for (const Index i : stages.kept) {
    if (!wanted(i)) continue;
    near.clear();
    tree.query(boost::geometry::index::nearest(input::tree_point(points[i]), neighbours + 1), std::back_inserter(near));
    for (const auto& [place, j] : near) {
      if (i == j || !wanted(j)) continue;
      const double cosine = std::min(1.0, std::abs(dot(planes[i].normal, planes[j].normal)));
      const double curvature = std::sqrt(2 * (1 - cosine)) / distance(points[i], points[j]);
      for (const Index end : {i, j}) visit(end, stages.control.phi[end] * curvature);
    }
  }
}

}  // namespace

Claim claim_curvature(const PlacedSurface& surface) {
  const SampleStages& stages = *surface.sample;
  Gauge gauge("phi_to_curvature_radius", "phi over radius of curvature <= 0.3", "practice", Claim::Sense::at_most,
              good_epsilon, stages.control.phi.size());
  visit_turns(
      stages, [](Index) { return true; }, [&](Index i, double value) { gauge.add(i, value); });
  return std::move(gauge).finish("no points were kept");
}

double least_epsilon(const PlacedSurface& surface) {
  const SampleStages& stages = *surface.sample;
  const auto inside = [&](Index i) { return stages.control.state[i] == PointState::ok; };
  const auto count = static_cast<double>(std::ranges::count_if(stages.kept, inside));
  const bool narrow = count < (1 - most_on_rim) * static_cast<double>(stages.kept.size());
  if (!surface.mesh || surface.mesh->closed() || narrow) return claim_curvature(surface).measured;
  double least = std::numeric_limits<double>::quiet_NaN();
  visit_turns(stages, inside, [&](Index, double value) { least = std::fmax(least, value); });
  return std::isnan(least) ? claim_curvature(surface).measured : least;
}

}  // namespace geodrome
