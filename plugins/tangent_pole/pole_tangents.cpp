// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/tangent_pole/pole_tangents.hpp"

#include <algorithm>
#include <cmath>

#include "geodrome/spatial_order.hpp"
#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/local_plane.hpp"
#include "plugins/tangent_pole/poles.hpp"

namespace geodrome {
namespace {

constexpr std::size_t fallback_neighbours = 20;
constexpr std::size_t residual_neighbours = 12;

double residual(const Neighbours& neighbours, Index at, const Vec3& normal, std::vector<Neighbour>& around) {
  const std::vector<Vec3>& points = neighbours.points();
  neighbours.nearest_and_ties(points[at], residual_neighbours, around, at);
  double squares = 0;
  for (const Neighbour& n : around) squares += std::pow(dot(normal, points[n.index] - points[at]), 2);
  return std::sqrt(squares / static_cast<double>(around.size()));
}

}  // namespace

Tangents PoleTangents::estimate(const PointSample& sample, RunContext& context) const {
  require_three_points(sample.size());
  context.throw_if_cancelled();
  const std::vector<Pole> poles = voronoi_poles(sample.points);
  const Neighbours neighbours(sample.points);
  const std::vector<Index> order = spatial_order(sample.points);
  Tangents tangents;
  tangents.plane.resize(sample.size());
  tangents.state.assign(sample.size(), PointState::ok);
  parallel_for(sample.size(), context, {0.8, 1}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = order[k];
      Vec3 normal = poles[i].direction;
      if (poles[i].kind == Pole::Kind::none) {
        const LocalPlane plane = grown_plane(neighbours, i, fallback_neighbours, around);
        if (plane.collinear()) throw_collinear(i, sample.size());
        normal = plane.normal;
      }
      tangents.plane[i] = {sample.points[i], normal, residual(neighbours, i, normal, around)};
    }
  });
  const auto count = [&](Pole::Kind kind) {
    return static_cast<double>(
        std::count_if(poles.begin(), poles.end(), [&](const Pole& pole) { return pole.kind == kind; }));
  };
  context.measure("fallback", count(Pole::Kind::none));
  context.measure("unbounded", count(Pole::Kind::unbounded));
  return tangents;
}

}  // namespace geodrome
