// SPDX-License-Identifier: MIT
#include "engine/smooth/fronts/path_end.hpp"

#include "engine/smooth/fronts/arrival.hpp"
#include "engine/smooth/fronts/spread.hpp"
#include "engine/smooth/piece_length.hpp"

namespace geodrome {

namespace {

SurfacePoint between(const SurfacePoint& p, const SurfacePoint& q, double share) {
  SurfacePoint at = p;
  for (int i = 0; i < 3; ++i) at.b[i] += share * (q.b[i] - p.b[i]);
  return at;
}

/// How geodesics that start at the last node are spread at the first one.
Spread spread_at_begin(const EdgeCurves& curves, std::span<const CurveNode> nodes,
                       std::span<const SmoothPoint> points) {
  Spread spread{0, 1};
  for (std::size_t i = nodes.size() - 1; i > 0; --i) {
    const SurfacePoint &from = nodes[i].place.at, &to = nodes[i - 1].place.at;
    const double begin = curves.curvature(from), end = curves.curvature(to);
    const double middle = from.face == to.face ? curves.curvature(between(from, to, 0.5)) : (begin + end) / 2;
    spread = spread.after(length_between(points[i], points[i - 1]), {begin, middle, end});
  }
  return spread;
}

}  // namespace

FrontPoint front_at_end(const EdgeCurves& curves, Shortening& shortening, std::size_t path, Index vertex) {
  const SmoothLength& length = shortening.lengths()[path];
  FrontPoint point{
      .distance = length.length, .error = length.error, .flat = length.flat - length.smooth, .moved = length.moved};
  const auto curve = shortening.smooth_curve(path);
  if (!curve || vertex == no_index) return point;
  const auto [nodes, points] = *curve;
  const VertexShape& shape = curves.vertex(vertex);
  const Vec3 chord = points[0].position - points[1].position;
  point.gradient =
      arriving(chord / norm(chord), length_between(points[1], points[0]), points[1].normal, shape.normal, shape.turn);
  const Spread spread = spread_at_begin(curves, nodes, points);
  if (spread.apart > 0) point.bend = point.distance * spread.slope / spread.apart;
  return point;
}

}  // namespace geodrome
