// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "geodrome/geometry.hpp"

/// In which direction a short piece of a geodesic arrives at its end: not in that of the chord, seen along the normal,
/// for its torsion turns it aside.
namespace geodrome {

/// Two orthogonal unit vectors of a tangent plane; `left`: seen against the normal, of who goes along.
struct Heading {
  Vec3 along, left;
};

namespace arrival {

inline Heading of_chord(const Vec3& unit_chord, const Vec3& normal) {
  const Vec3 flat = unit_chord - dot(unit_chord, normal) * normal;
  const Vec3 along = flat / norm(flat);
  return {along, cross(normal, along)};
}

}  // namespace arrival

/// By the chord towards the end and the normals at begin and end: of second order in the length.
inline Heading arriving(const Vec3& unit_chord, const Vec3& from_normal, const Vec3& normal) {
  const auto [along, left] = arrival::of_chord(unit_chord, normal);
  const double aside = dot(from_normal, along) * dot(from_normal, left) / 6;
  return {along + aside * left, left - aside * along};
}

/// One order more, by the matrix `turn` by which the normal changes at the end. With the normal curvature k and the
/// torsion t of the piece and their changes, the chord lies aside by k t / 6 - (2 k' t + k t') / 24, all in lengths of
/// the piece.
inline Vec3 arriving(const Vec3& unit_chord, double length, const Vec3& from_normal, const Vec3& normal,
                     const std::array<Vec3, 3>& turn) {
  const auto [along, left] = arrival::of_chord(unit_chord, normal);
  const Vec3 turned = length * Vec3{dot(turn[0], along), dot(turn[1], along), dot(turn[2], along)};
  const double k = -dot(turned, along), t = dot(turned, left);
  const double k_change = 2 * (k - dot(from_normal, along)), t_change = 2 * (t + dot(from_normal, left));
  const Vec3 direction = along - (k * t / 6 - (2 * k_change * t + k * t_change) / 24) * left;
  return direction / norm(direction);
}

}  // namespace geodrome
