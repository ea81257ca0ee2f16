// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/cheapest_crossing.hpp"

#include <algorithm>
#include <cmath>

#include "geodrome/geometry.hpp"

namespace geodrome::aleksandrov {
namespace {

/// How far to the side of a point at this height the edge is reached at the critical angle; infinity if going along
/// the edge is no cheaper than going beside it.
double critical_offset(double height, double weight, double along) {
  if (height == 0) return 0;
  if (along >= weight) return infinity;
  const double sine = along / weight;  // 1 - sine by the difference, which is exact where it is small
  return height * sine / std::sqrt((weight - along) / weight * (1 + sine));
}

/// Where a line refracts between heights h and k that are dx apart, from below h. Newton's method on the derivative of
/// the cost, which grows with u; kept between bounds.
double refraction(double h, double above, double k, double below, double dx) {
  double low = 0, high = dx, u = dx * h / (h + k);
  for (int step = 0; step < 60; ++step) {
    const double v = dx - u, first = std::hypot(u, h), second = std::hypot(v, k);
    const double slope = above * u / first - below * v / second;
    const double growth = above * h * h / (first * first * first) + below * k * k / (second * second * second);
    (slope > 0 ? high : low) = u;
    double next = u - slope / growth;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - u) <= 1e-15 * std::min(u, v)) break;
    u = next;
  }
  return u;
}

}  // namespace

Crossing cheapest_crossing(Point2 p, double above, Point2 q, double below, double along) {
  const double dx = std::abs(q.x - p.x), h = p.y, k = -q.y, way = q.x < p.x ? -1 : 1;
  const double from = critical_offset(h, above, along), to = critical_offset(k, below, along);
  if (from + to <= dx)
    return {above * std::hypot(from, h) + along * (dx - from - to) + below * std::hypot(to, k), p.x + way * from,
            q.x - way * to};
  const double u = h == 0 ? 0 : k == 0 || dx == 0 ? dx : refraction(h, above, k, below, dx);
  return {above * std::hypot(u, h) + below * std::hypot(dx - u, k), p.x + way * u, p.x + way * u};
}

}  // namespace geodrome::aleksandrov
