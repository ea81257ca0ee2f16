// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/// Geodrome: a modular plugin-based engine for geodesic distances on surfaces.
namespace geodrome {

/// Position of an element in an array, counted from 0.
using Index = std::uint32_t;

/// "There is no such element."
inline constexpr Index no_index = std::numeric_limits<Index>::max();

/// The distance of what cannot be reached.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point or a direction in space, in the units of the input.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, double s) { return s * a; }
  friend constexpr Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }
};

/// Products, lengths and distances in the units of the input. `norm` and `distance` overflow where squares do.
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_norm(const Vec3& a) { return dot(a, a); }
inline double norm(const Vec3& a) { return std::sqrt(squared_norm(a)); }
constexpr double squared_distance(const Vec3& a, const Vec3& b) { return squared_norm(a - b); }
inline double distance(const Vec3& a, const Vec3& b) { return norm(a - b); }
inline bool is_finite(const Vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// A sample S of an unknown surface (Definition 1). The engine hands plugins only samples whose points are finite and
/// pairwise distinct; indices count from 0 and are the same in every stage.
struct PointSample {
  std::vector<Vec3> points;

  std::size_t size() const noexcept { return points.size(); }
};

}  // namespace geodrome
