// SPDX-License-Identifier: MIT
#include "plugins/control_constant/constant_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geodrome/spatial_order.hpp"
#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/live_points.hpp"
#include "plugins/common/points/neighbours.hpp"
#include "plugins/common/points/noise_floor.hpp"

namespace geodrome {
namespace {

/// The median distance of a point from its sixth nearest, or its farthest if there are fewer. The median, since
/// outliers, clusters and the rows of a scanner move a mean.
double spacing_of(const LivePoints& live, RunContext& context) {
  if (live.size() < 2)
    throw SampleError("a single point has no spacing", "give more points, or the control function's value");
  const Neighbours neighbours(live.points);
  const std::vector<Index> order = spatial_order(live.points);
  std::vector<double> distances(live.size());
  parallel_for(live.size(), context, {0, 1}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> near;
    for (std::size_t k = begin; k < end; ++k) {
      neighbours.nearest(live.points[order[k]], spacing_rank, near, order[k]);
      distances[k] = std::sqrt(near.back().squared_distance);
    }
  });
  const auto median = distances.begin() + static_cast<std::ptrdiff_t>((distances.size() - 1) / 2);
  std::nth_element(distances.begin(), median, distances.end());
  if (*median > 0) return *median;
  throw SampleError("most points coincide with their six nearest, so the sample has no spacing",
                    "merge equal points, or give the control function's value");
}

}  // namespace

Control ConstantControl::evaluate(const PointSample& sample, const Tangents& tangents, RunContext& context) const {
  constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();
  context.throw_if_cancelled();
  Control control{std::vector(sample.size(), not_computed), std::vector(sample.size(), not_computed), tangents.state};
  const LivePoints live = live_points(sample, tangents.state);
  if (live.size() == 0) return control;
  double phi = settings_.value;
  if (phi == 0) {
    const double spacing = spacing_of(live, context);
    context.measure("spacing", spacing);
    phi = spacing_factor * spacing;
  }
  const double least = noise_factor * tangents.sigma;
  const double psi = std::max(phi, least);
  for (const Index i : live.sample_index) {
    control.phi[i] = phi;
    control.psi[i] = psi;
  }
  context.measure("psi", psi);
  context.measure("raised_to_noise", phi < least ? static_cast<double>(live.size()) : 0);
  context.progress(1);
  return control;
}

}  // namespace geodrome
