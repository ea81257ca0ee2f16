// SPDX-License-Identifier: MIT
#include "plugins/decimator_greedy/open_sample.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/common/points/boundary_points.hpp"
#include "plugins/common/points/local_plane.hpp"

namespace geodrome {
namespace {

constexpr double most_spacings = 3;
/// Points of a rim that are nearer to each other tell nothing more of it, and make needles.
constexpr double rim_spacings = 0.3;
/// Faces have a circumradius of up to 2.5 psi: what lies within may be joined.
constexpr double joined_within = 2.5;
/// Noise stays below it, since psi is at least 5 sigma.
constexpr double most_height = 0.75;
constexpr std::size_t around = 17;
/// Some eighty points lie so near in a uniform sample; where psi is far above the spacing there is no end of them.
constexpr std::size_t looked_at = 200;

std::vector<char> bent_points(const LivePoints& live, const Control& control, RunContext& context) {
  const Neighbours neighbours(live.points);
  std::vector<char> bent(live.size(), 0);
  parallel_for(live.size(), context, {0.1, 0.3}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> near;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 normal = grown_plane(neighbours, static_cast<Index>(i), around, near).normal;
      const double psi = control.psi[live.sample_index[i]];
      neighbours.nearest(live.points[i], looked_at, near, static_cast<Index>(i));
      bent[i] = std::ranges::any_of(near, [&](const Neighbour& n) {
        if (std::sqrt(n.squared_distance) > joined_within * psi) return false;
        return std::abs(dot(live.points[n.index] - live.points[i], normal)) > most_height * psi;
      });
    }
  });
  return bent;
}

}  // namespace

OpenSample open_sample(const PointSample& sample, const Control& control, const LivePoints& live, RunContext& context) {
  const std::vector<double> spacing = boundary_spacing(sample, control, context, {0, 0.1});
  OpenSample result;
  if (std::ranges::none_of(spacing, [](double s) { return s > 0; })) return result;
  for (const Index s : live.sample_index)
    result.rim_step.push_back(control.psi[s] <= most_spacings * spacing[s] ? rim_spacings * spacing[s] : 0);
  result.bent = bent_points(live, control, context);
  return result;
}

}  // namespace geodrome
