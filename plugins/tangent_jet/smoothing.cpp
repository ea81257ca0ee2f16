// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "plugins/common/points/local_plane.hpp"
#include "plugins/tangent_jet/local_jet.hpp"

namespace geodrome {
namespace {

/// Weights fall to exp(-2) at the last neighbour: the projection is then nearly smooth, and most points count.
constexpr double smoothing_decay = 2;

TangentPlane project(const Neighbours& neighbours, Index at, std::size_t k, std::vector<Neighbour>& around) {
  const std::vector<Vec3>& points = neighbours.points();
  TangentPlane plane{points[at], {}, 0};
  for (const bool first : {true, false}) {
    neighbours.nearest_and_ties(plane.origin, k, around);
    const LocalPlane flat = first ? plane_of(points, plane.origin, around) : LocalPlane{plane.normal};
    const Quadric quadric = fit_quadric(points, plane.origin, flat.normal, around, smoothing_decay);
    double squares = 0;
    for (const Neighbour& n : around) squares += std::pow(quadric.residual(points[n.index] - plane.origin), 2);
    plane.residual = std::sqrt(squares / static_cast<double>(around.size()));
    plane.origin = plane.origin + quadric.height() * quadric.n;
    plane.normal = quadric.normal();
  }
  return plane;
}

auto key(const Vec3& p) { return std::tuple(p.x, p.y, p.z); }

}  // namespace

std::vector<TangentPlane> smoothed_planes(const Neighbours& neighbours, std::span<const Index> order, std::size_t k,
                                          RunContext& context, ProgressShare share) {
  std::vector<TangentPlane> planes(order.size());
  parallel_for(order.size(), context, share, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t i = begin; i < end; ++i) planes[order[i]] = project(neighbours, order[i], k, around);
  });
  return planes;
}

std::size_t separate(std::span<TangentPlane> planes, std::span<const Vec3> points) {
  std::vector<Index> order(planes.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::size_t restored = 0;
  for (std::size_t before = 0;; before = restored) {
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return key(planes[a].origin) < key(planes[b].origin); });
    for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
      const Vec3 place = planes[order[begin]].origin;
      for (end = begin + 1; end < order.size() && planes[order[end]].origin == place;) ++end;
      for (std::size_t i = begin; end - begin > 1 && i < end; ++i) {
        Vec3& origin = planes[order[i]].origin;
        restored += origin != points[order[i]];
        origin = points[order[i]];
      }
    }
    if (restored == before) return restored;
  }
}

}  // namespace geodrome
