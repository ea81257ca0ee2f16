// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/geometry.hpp"

namespace geodrome::shapes {

/// A symmetric 3 x 3 matrix.
struct Symmetric3 {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  friend constexpr Symmetric3 operator+(const Symmetric3& a, const Symmetric3& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
  }
  friend constexpr Symmetric3 operator*(double s, const Symmetric3& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
  }
  friend constexpr Vec3 operator*(const Symmetric3& a, const Vec3& v) {
    return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
            a.xz * v.x + a.yz * v.y + a.zz * v.z};
  }
};

inline constexpr Symmetric3 identity3{1, 1, 1, 0, 0, 0};

/// a b^T + b a^T.
constexpr Symmetric3 symmetric_product(const Vec3& a, const Vec3& b) {
  return {2 * a.x * b.x,         2 * a.y * b.y,         2 * a.z * b.z,
          a.x * b.y + a.y * b.x, a.x * b.z + a.z * b.x, a.y * b.z + a.z * b.y};
}

/// a a^T.
constexpr Symmetric3 square(const Vec3& a) { return 0.5 * symmetric_product(a, a); }

/// A function of space and its derivatives at a point.
struct LevelValue {
  double value = 0;  ///< of a surface f = 0: negative inside
  Vec3 gradient;     ///< points outwards on the surface
  Symmetric3 hessian;
};

}  // namespace geodrome::shapes
