// SPDX-License-Identifier: MIT
#include "plugins/control_lipschitz/lipschitz_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geodrome/spatial_order.hpp"
#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/cell_radius.hpp"
#include "plugins/common/points/live_points.hpp"
#include "plugins/common/points/maximum_tree.hpp"

namespace geodrome {
namespace {

constexpr std::size_t cap_neighbours = 17;
constexpr double cap_factor = 1.5;

std::vector<CellRadius> cell_radii(const Neighbours& neighbours, const std::vector<Index>& order,
                                   const LivePoints& live, const Tangents& tangents, RunContext& context) {
  const double reach = sample_reach(live.points);
  std::vector<CellRadius> cells(live.size());
  parallel_for(live.size(), context, {0, 0.6}, [&](std::size_t begin, std::size_t end) {
    CellRadiusFinder find(neighbours, reach);
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = order[k];
      cells[i] = find(i, tangents.plane[live.sample_index[i]].normal);
    }
  });
  return cells;
}

/// The largest phi that each point is allowed.
std::vector<double> caps(const Neighbours& neighbours, const std::vector<Index>& order,
                         const std::vector<CellRadius>& cells, RunContext& context) {
  std::vector<double> limit(cells.size(), infinity);
  if (cells.size() < 2) return limit;
  parallel_for(cells.size(), context, {0.6, 0.8}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    std::vector<double> phi;
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = order[k];
      neighbours.nearest_and_ties(neighbours.points()[i], cap_neighbours, around, i);
      phi.clear();
      for (const Neighbour& n : around) phi.push_back(cells[n.index].phi);
      const auto median = phi.begin() + (phi.size() - 1) / 2;
      std::nth_element(phi.begin(), median, phi.end());
      limit[i] = cap_factor * *median;
    }
  });
  return limit;
}

/// Equation (1). In leaf order the previous result bounds the next from below, so that little of the tree is left to
/// visit.
std::vector<double> envelope(const std::vector<Vec3>& points, const std::vector<double>& phi, RunContext& context) {
  std::vector<double> weights;
  for (const double value : phi) weights.push_back(phi_factor * value);
  const MaximumTree tree(points, weights, psi_slope);
  const std::span<const Index> order = tree.leaf_order();
  // All values are differences of numbers up to the largest weight; a few ulp of it are far below this.
  const double rounding = 1e-12 * *std::max_element(weights.begin(), weights.end());
  std::vector<double> psi(points.size());
  parallel_for(points.size(), context, {0.8, 1}, [&](std::size_t begin, std::size_t end) {
    double at_least = -infinity;
    for (std::size_t k = begin; k < end; ++k) {
      const Vec3& p = points[order[k]];
      psi[order[k]] = tree.evaluate(p, at_least);
      if (k + 1 == end) break;
      at_least = psi[order[k]] - psi_slope * distance(p, points[order[k + 1]]) - rounding;
    }
  });
  return psi;
}

}  // namespace

Control LipschitzControl::evaluate(const PointSample& sample, const Tangents& tangents, RunContext& context) const {
  constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();
  Control control{std::vector(sample.size(), not_computed), std::vector(sample.size(), not_computed), tangents.state};
  const LivePoints live = live_points(sample, tangents.state);
  if (live.size() == 0) return control;
  const Neighbours neighbours(live.points);
  const std::vector<Index> order = spatial_order(live.points);
  const std::vector<CellRadius> cells = cell_radii(neighbours, order, live, tangents, context);

  const std::vector<double> limit = settings_.cap ? caps(neighbours, order, cells, context) : std::vector<double>();
  std::vector<double> phi(live.size());
  std::size_t unbounded = 0, capped = 0;
  for (std::size_t i = 0; i < live.size(); ++i) {
    const bool cut = settings_.cap && cells[i].phi > limit[i];
    phi[i] = cut ? limit[i] : cells[i].phi;
    PointState& state = control.state[live.sample_index[i]];
    if (cut) state = PointState::capped;
    if (!cells[i].bounded) state = PointState::unbounded;
    capped += cut;
    unbounded += !cells[i].bounded;
  }
  const std::vector<double> psi = envelope(live.points, phi, context);
  const double least = noise_factor * tangents.sigma;
  std::size_t raised = 0;
  for (std::size_t i = 0; i < live.size(); ++i) {
    control.phi[live.sample_index[i]] = phi[i];
    control.psi[live.sample_index[i]] = std::max(psi[i], least);
    raised += psi[i] < least;
  }
  context.measure("unbounded", static_cast<double>(unbounded));
  context.measure("capped", static_cast<double>(capped));
  context.measure("raised_to_noise", static_cast<double>(raised));
  return control;
}

}  // namespace geodrome
