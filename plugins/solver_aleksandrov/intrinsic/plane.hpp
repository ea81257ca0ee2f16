// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace geodrome::aleksandrov {

/// A point or vector of the plane that faces are laid out in.
struct Point2 {
  double x = 0, y = 0;

  friend Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Point2 operator*(double s, Point2 a) { return {s * a.x, s * a.y}; }
};

inline double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Point2 a) { return std::hypot(a.x, a.y); }

using Barycentric = std::array<double, 3>;
using Triangle2 = std::array<Point2, 3>;

inline Point2 place(const Triangle2& t, const Barycentric& b) {
  // From the corner it is nearest to, so that it is exact there.
  const int i = static_cast<int>(std::max_element(b.begin(), b.end()) - b.begin());
  return t[i] + b[(i + 1) % 3] * (t[(i + 1) % 3] - t[i]) + b[(i + 2) % 3] * (t[(i + 2) % 3] - t[i]);
}

/// The coordinates of `p` in a triangle; of a point outside those of one near by inside. The longest side is the base,
/// so that the place they name is off by rounding of the triangle's size, however thin it is.
inline Barycentric barycentric(const Triangle2& t, Point2 p) {
  int base = 0;
  double longest = -1;
  for (int i = 0; i < 3; ++i) {
    const double side = length(t[(i + 1) % 3] - t[i]);
    if (side > longest) longest = side, base = i;
  }
  if (longest <= 0) return {1, 0, 0};
  const Point2 origin = t[base], along = (1 / longest) * (t[(base + 1) % 3] - origin);
  const Point2 apex = t[(base + 2) % 3] - origin, q = p - origin;
  const double height = cross(along, apex), foot = std::clamp(dot(along, apex), 0.0, longest);
  const double x = std::clamp(dot(along, q), 0.0, longest);
  // No higher than the triangle is there: in one without area heights are rounding, and places along it are not.
  const double most = x < foot ? x / foot : x > foot ? (longest - x) / (longest - foot) : 1;
  const double top = height > 0 ? std::clamp(cross(along, q) / height, 0.0, most) : 0;
  const double second = std::clamp((x - top * foot) / longest, 0.0, 1 - top);
  Barycentric b;
  b[base] = 1 - top - second, b[(base + 1) % 3] = second, b[(base + 2) % 3] = top;
  return b;
}

}  // namespace geodrome::aleksandrov
