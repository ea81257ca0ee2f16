// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A number that depends on two variables s and t, with its derivatives up to the second order.
struct Dual {
  double value = 0, s = 0, t = 0, ss = 0, st = 0, tt = 0;

  friend constexpr Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.s + b.s, a.t + b.t, a.ss + b.ss, a.st + b.st, a.tt + b.tt};
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.s - b.s, a.t - b.t, a.ss - b.ss, a.st - b.st, a.tt - b.tt};
  }
  friend constexpr Dual operator*(double k, const Dual& a) {
    return {k * a.value, k * a.s, k * a.t, k * a.ss, k * a.st, k * a.tt};
  }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value,
            a.s * b.value + a.value * b.s,
            a.t * b.value + a.value * b.t,
            a.ss * b.value + 2 * a.s * b.s + a.value * b.ss,
            a.st * b.value + a.s * b.t + a.t * b.s + a.value * b.st,
            a.tt * b.value + 2 * a.t * b.t + a.value * b.tt};
  }
};

/// f(a), by the value of f at `a.value` and its first two derivatives there.
constexpr Dual chain(const Dual& a, double f, double f1, double f2) {
  return {f, f1 * a.s, f1 * a.t, f1 * a.ss + f2 * a.s * a.s, f1 * a.st + f2 * a.s * a.t, f1 * a.tt + f2 * a.t * a.t};
}

/// Derivatives are infinite at 0.
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return chain(a, root, 0.5 / root, -0.25 / (a.value * root));
}

inline Dual inverse(const Dual& a) {
  const double f = 1 / a.value;
  return chain(a, f, -f * f, 2 * f * f * f);
}

/// A point or a direction in space that depends on s and t.
struct DualVec3 {
  Vec3 value, s, t, ss, tt;  // what the length of a piece needs has no mixed derivative
};

constexpr Dual dot(const DualVec3& a, const DualVec3& b) {
  return {dot(a.value, b.value),
          dot(a.s, b.value) + dot(a.value, b.s),
          dot(a.t, b.value) + dot(a.value, b.t),
          dot(a.ss, b.value) + 2 * dot(a.s, b.s) + dot(a.value, b.ss),
          dot(a.s, b.t) + dot(a.t, b.s),
          dot(a.tt, b.value) + 2 * dot(a.t, b.t) + dot(a.value, b.tt)};
}

}  // namespace geodrome
