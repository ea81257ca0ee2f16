// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/smooth/dual.hpp"
#include "geodrome/smooth_surface.hpp"

/// The length of a piece of a geodesic on a smooth surface from its two ends and the normals there: with the chord c
/// and the angles a, b that it makes with the planes across the normals, c (1 + (2 a^2 + 2 b^2 - a b) / 30 + 7 a^2 b^2
/// / 360). Exact on spheres but for a^6; the relative error of a piece of length h is O(h^4) elsewhere.
namespace geodrome {

/// What a piece's length does when its ends move along their directions, by s and t.
using PieceLength = Dual;

namespace piece {

/// The arc sine with its first two derivatives, of the sine of an angle between a chord and the surface.
inline Dual angle(const Dual& sine) {
  const double x = std::clamp(sine.value, -1.0, 1.0), slope = 1 / std::sqrt(std::max(1 - x * x, 1e-12));
  return chain(sine, std::asin(x), slope, x * slope * slope * slope);
}

/// The product of the angles counts by the sides that the normals point to: those of faces that clash point apart.
inline double side(const Vec3& p, const Vec3& q) { return dot(p, q) < 0 ? -1 : 1; }

}  // namespace piece

/// The length alone; 0 if both ends are one point.
inline double length_between(const SmoothPoint& p, const SmoothPoint& q) {
  const Vec3 chord = q.position - p.position;
  const double c = norm(chord);
  if (c == 0) return 0;
  const double a = std::asin(std::clamp(dot(p.normal, chord) / c, -1.0, 1.0));
  const double b = std::asin(std::clamp(dot(q.normal, chord) / c, -1.0, 1.0));
  const double ab = a * b, squares = a * a + b * b;
  return c * (1 + (2 * squares - piece::side(p.normal, q.normal) * ab) / 30 + 7 * ab * ab / 360);
}

/// What a length leaves out whose pieces were halved: that divides the error by 16.
constexpr double left_by_halving(double halved, double whole) { return (halved - whole) / 15; }

/// Where a node comes to lie that moves along its direction, by its derivatives.
inline SmoothPoint moved(const SmoothPoint& node, double by) {
  SmoothPoint result = node;
  result.position = node.position + by * node.velocity + 0.5 * by * by * node.acceleration;
  result.normal = node.normal + by * node.normal_velocity;
  result.normal = result.normal / norm(result.normal);
  return result;
}

/// The length with its derivatives; the second ones are those of a length whose normals turn evenly. Precondition: the
/// ends differ.
inline PieceLength moving_length(const SmoothPoint& p, const SmoothPoint& q) {
  const DualVec3 chord{q.position - p.position, -p.velocity, q.velocity, -p.acceleration, q.acceleration};
  // How the normals' turning changes would count h^2 times what the chords do: it is left out.
  const DualVec3 from{p.normal, p.normal_velocity, {}, {}, {}}, to{q.normal, {}, q.normal_velocity, {}, {}};
  const Dual c = sqrt(dot(chord, chord)), over = inverse(c);
  const Dual a = piece::angle(dot(from, chord) * over), b = piece::angle(dot(to, chord) * over);
  const Dual ab = a * b;
  const Dual excess =
      (1 / 30.0) * (2 * (a * a + b * b) - piece::side(p.normal, q.normal) * ab) + (7 / 360.0) * (ab * ab);
  return c + c * excess;
}

}  // namespace geodrome
