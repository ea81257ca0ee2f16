// SPDX-License-Identifier: MIT
#include "engine/smooth/fronts/ray.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome {

namespace {

/// How a direction is made up of two sides of a triangle, times a positive number.
struct Sides {
  double first, second;
};

Sides sides_of(const Vec3& direction, const Vec3& first, const Vec3& second) {
  const double ff = dot(first, first), fs = dot(first, second), ss = dot(second, second);
  const double df = dot(direction, first), ds = dot(direction, second);
  return {df * ss - ds * fs, ds * ff - df * fs};
}

}  // namespace

std::optional<Ray> ray_from(const SurfaceMesh& mesh, const SurfacePoint& from, const Vec3& direction) {
  const auto [p, q, r] = mesh.corners(from.face);
  const auto [to_q, to_r] = sides_of(direction, q - p, r - p);
  const std::array<double, 3> gain{-(to_q + to_r), to_q, to_r};
  int out = -1;  // the corner whose coordinate is the first to be 0
  double least = infinity;
  for (int i = 0; i < 3; ++i)
    if (gain[i] < 0 && from.b[i] < least * -gain[i]) least = from.b[i] / -gain[i], out = i;
  if (out < 0) return std::nullopt;
  const int begin = (out + 1) % 3, end = (out + 2) % 3;
  const double b = from.b[begin] + least * gain[begin], e = from.b[end] + least * gain[end];
  return Ray{3 * from.face + begin, std::clamp(e / (b + e), 0.0, 1.0), direction};
}

std::optional<Ray> ray_from(const SurfaceMesh& mesh, std::span<const Index> starting, const Vec3& direction) {
  std::optional<Ray> best;
  double best_inside = -0.5;  // the ray may lie a little outside of all faces, where they make a hollow
  for (const Index h : starting) {
    const int i = h % 3;
    const std::array<Vec3, 3> corners = mesh.corners(h / 3);
    const auto [first, second] =
        sides_of(direction, corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]);
    if (!(first + second > 0)) continue;
    const double share = second / (first + second), inside = std::min(share, 1 - share);
    if (!(inside > best_inside)) continue;
    best_inside = inside;
    best = {SurfaceMesh::next(h), std::clamp(share, 0.0, 1.0), direction};
    if (inside >= 0) break;
  }
  return best;
}

std::optional<Ray> next_face(const SurfaceMesh& mesh, const Ray& ray) {
  const Index twin = mesh.twins()[ray.half_edge];
  if (twin == no_index) return std::nullopt;
  const std::array<Vec3, 3> corners = mesh.corners(twin / 3);
  const int i = twin % 3;
  const Vec3 edge = corners[(i + 1) % 3] - corners[i], side = corners[(i + 2) % 3] - corners[i];
  const Vec3 along = edge / norm(edge);
  const Vec3 inward = side - dot(side, along) * along;
  const double forward = dot(ray.direction, along), aside = norm(ray.direction - forward * along);
  const Vec3 direction = forward * along + aside / norm(inward) * inward;
  SurfacePoint at{twin / 3, {}};
  at.b[i] = ray.share, at.b[(i + 1) % 3] = 1 - ray.share;
  const auto next = ray_from(mesh, at, direction);
  return next && next->half_edge != twin ? next : std::nullopt;
}

}  // namespace geodrome
