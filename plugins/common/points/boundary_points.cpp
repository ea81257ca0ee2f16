// SPDX-License-Identifier: MIT
#include "plugins/common/points/boundary_points.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "geodrome/surface.hpp"
#include "plugins/common/points/cell_radius.hpp"
#include "plugins/common/points/live_points.hpp"
#include "plugins/common/points/local_plane.hpp"

namespace geodrome {
namespace {

/// Neighbours that show the tangent plane, and how densely the sample lies where its density changes.
constexpr std::size_t around = 17;
/// Neighbours that show the spacing: those on the boundary itself are few among them.
constexpr std::size_t far_around = 64;
/// The planar cell of a point beside a slit of four spacings reaches over two of them.
constexpr double far_cell = 2;
/// Points of one boundary are nearer to each other: in a uniform sample hardly any gap along a rim is longer.
constexpr double longest_step = 4;
/// Points with smaller cells count if one that counts is as near.
constexpr double beside_it = 2.5;

/// Points that may lie on a boundary, and those that may if such are near.
struct Candidates {
  std::vector<Index> points;  ///< packed, ascending
  std::vector<double> spacing;
  std::vector<char> sure;
};

double lower_quartile(std::span<const Neighbour> near, const LivePoints& live, const std::vector<double>& phi) {
  std::vector<double> values;
  for (const Neighbour& n : near) values.push_back(phi[live.sample_index[n.index]]);
  const auto quartile = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 4);
  std::nth_element(values.begin(), quartile, values.end());
  return *quartile;
}

Candidates candidates_of(const LivePoints& live, const Neighbours& neighbours, const Control& control,
                         RunContext& context, ProgressShare share) {
  std::vector<Index> flagged;
  for (Index i = 0; i < live.size(); ++i) {
    const PointState state = control.state[live.sample_index[i]];
    if (state == PointState::unbounded || state == PointState::capped) flagged.push_back(i);
  }
  Candidates found{flagged, std::vector<double>(flagged.size()), std::vector<char>(flagged.size())};
  const double reach = flagged.empty() ? 0 : sample_reach(live.points);
  parallel_for(flagged.size(), context, share, [&](std::size_t begin, std::size_t end) {
    CellRadiusFinder cell(neighbours, reach);
    std::vector<Neighbour> near;
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = flagged[k];
      neighbours.nearest_and_ties(live.points[i], far_around, near, i);
      const double step = lower_quartile(near, live, control.phi);
      const Index s = live.sample_index[i];
      const std::span first(near.data(), std::min(near.size(), around));
      const double limit = far_cell * std::max(step, lower_quartile(first, live, control.phi));
      found.spacing[k] = step;
      found.sure[k] = control.state[s] == PointState::unbounded || control.phi[s] > limit ||
                      cell(i, grown_plane(neighbours, i, around, near).normal).phi > limit;
    }
  });
  return found;
}

}  // namespace

std::vector<double> boundary_spacing(const PointSample& sample, const Control& control, RunContext& context,
                                     ProgressShare share) {
  std::vector<double> result(sample.size(), 0);
  const LivePoints live = live_points(sample, control.state);
  if (live.size() <= least_boundary) return result;
  const Candidates found = candidates_of(live, Neighbours(live.points), control, context, share);
  if (found.points.size() < least_boundary) return result;
  std::vector<Vec3> places;
  for (const Index i : found.points) places.push_back(live.points[i]);
  const Neighbours others(std::move(places));
  const auto near = [&](Index k) {
    std::vector<Neighbour> around_it;
    others.within(others.points()[k], longest_step * found.spacing[k], around_it, k);
    return around_it;
  };
  const auto count = static_cast<Index>(found.points.size());
  detail::DisjointSets groups(count);
  for (Index k = 0; k < count; ++k)
    for (const Neighbour& n : near(k))
      if (found.sure[k] && found.sure[n.index]) groups.unite(k, n.index);
  std::vector<std::size_t> size(count, 0);
  for (Index k = 0; k < count; ++k) ++size[groups.find(k)];
  const auto on_boundary = [&](Index k) { return size[groups.find(k)] >= least_boundary; };
  for (Index k = 0; k < count; ++k) {
    const auto beside = [&](const Neighbour& n) {
      return on_boundary(n.index) && std::sqrt(n.squared_distance) <= beside_it * found.spacing[k];
    };
    if (on_boundary(k) || std::ranges::any_of(near(k), beside))
      result[live.sample_index[found.points[k]]] = found.spacing[k];
  }
  return result;
}

}  // namespace geodrome
