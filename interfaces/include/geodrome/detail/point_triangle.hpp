// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "geodrome/geometry.hpp"

namespace geodrome::detail {

/// A point of a triangle, with its squared distance from the point it was sought for.
struct TrianglePoint {
  std::array<double, 3> b{};  ///< barycentric coordinates, >= 0, sum 1 to rounding; exactly 1 and 0 at a corner
  double squared_distance = 0;
};

// All corners are taken relative to the query, which is then the origin: distances keep their relative precision, and a
// query at a corner has distance 0 exactly.

inline TrianglePoint at_barycentric(const std::array<Vec3, 3>& corners, const std::array<double, 3>& b) {
  return {b, squared_norm(b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2])};
}

/// The closest point of the edge from corner i to corner j, computed from its lower to its higher end (in lexicographic
/// order), so that both faces of an edge get the same.
inline TrianglePoint closest_on_edge(const std::array<Vec3, 3>& corners, int i, int j) {
  const auto order = [](const Vec3& v) { return std::tie(v.x, v.y, v.z); };
  if (order(corners[j]) < order(corners[i])) std::swap(i, j);
  const Vec3 &u = corners[i], &v = corners[j], along = v - u;
  const double length2 = squared_norm(along);
  const double t = length2 > 0 ? std::clamp(-dot(u, along) / length2, 0.0, 1.0) : 0.0;
  std::array<double, 3> b{};
  b[i] = 1 - t, b[j] = t;
  return {b, squared_norm(b[i] * u + b[j] * v)};
}

/// The foot of the perpendicular on the triangle's plane, where it falls inside; else the first corner.
inline TrianglePoint foot_inside(const std::array<Vec3, 3>& corners) {
  const auto& [p, q, r] = corners;
  const Vec3 normal = cross(q - p, r - p);
  // Twice the areas opposite to each corner, times |normal|; each from the edge it stands on, which keeps the error
  // proportional to the distance from that edge.
  const std::array<double, 3> area = {dot(normal, cross(q, r - q)), dot(normal, cross(r, p - r)),
                                      dot(normal, cross(p, q - p))};
  const double total = area[0] + area[1] + area[2];
  if (!(area[0] > 0 && area[1] > 0 && area[2] > 0) || !std::isfinite(total)) return at_barycentric(corners, {1, 0, 0});
  return at_barycentric(corners, {area[0] / total, area[1] / total, area[2] / total});
}

/// The point of a triangle that is closest to `query`. The triangle may be degenerate: a segment or a point. Two
/// triangles that share an edge in opposite directions get bitwise the same distance where the closest point is on that
/// edge. O(1).
inline TrianglePoint closest_on_triangle(const Vec3& query, const std::array<Vec3, 3>& corners) {
  const std::array<Vec3, 3> relative = {corners[0] - query, corners[1] - query, corners[2] - query};
  // The closest point is on an edge or the foot inside. Taking the least of the four needs no classification that
  // rounding or a degenerate triangle could upset: each is a point of the triangle, with its true distance.
  TrianglePoint best = closest_on_edge(relative, 0, 1);
  for (const TrianglePoint& other :
       {closest_on_edge(relative, 1, 2), closest_on_edge(relative, 2, 0), foot_inside(relative)})
    if (other.squared_distance < best.squared_distance) best = other;
  return best;
}

}  // namespace geodrome::detail
