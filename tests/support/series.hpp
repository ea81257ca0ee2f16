// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "geodrome/geometry.hpp"

/// Numbers and points that depend on one variable, with two derivatives: a function that is written for any number type
/// gives its own.
namespace geodrome::test {

struct Series {
  double value = 0, first = 0, second = 0;

  constexpr Series() = default;
  constexpr Series(double constant) : value(constant) {}
  constexpr Series(double v, double d, double dd) : value(v), first(d), second(dd) {}

  friend constexpr Series operator+(const Series& a, const Series& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }
  friend constexpr Series operator-(const Series& a, const Series& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
  }
  friend constexpr Series operator*(const Series& a, const Series& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2 * a.first * b.first + a.value * b.second};
  }
  friend constexpr Series operator/(const Series& a, const Series& b) {
    return a * b.through(1 / b.value, -1 / (b.value * b.value), 2 / (b.value * b.value * b.value));
  }

  /// f of this number, by f and its derivatives at `value`.
  constexpr Series through(double f, double f1, double f2) const {
    return {f, f1 * first, f1 * second + f2 * first * first};
  }
};

inline Series sqrt(const Series& a) {
  const double root = std::sqrt(a.value);
  return a.through(root, 0.5 / root, -0.25 / (a.value * root));
}
inline Series sin(const Series& a) { return a.through(std::sin(a.value), std::cos(a.value), -std::sin(a.value)); }
inline Series cos(const Series& a) { return a.through(std::cos(a.value), -std::sin(a.value), -std::cos(a.value)); }

/// A vector of any numbers.
template <class Number>
struct Vector {
  Number x, y, z;

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Number& k, const Vector& a) { return {k * a.x, k * a.y, k * a.z}; }
};

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The unit vector of that direction.
template <class Number>
Vector<Number> unit(const Vector<Number>& a) {
  using std::sqrt;
  return Number(1) / sqrt(dot(a, a)) * a;
}

inline Vector<Series> moving(const Vec3& at, const Vec3& velocity) {
  return {{at.x, velocity.x, 0}, {at.y, velocity.y, 0}, {at.z, velocity.z, 0}};
}
inline Vec3 value(const Vector<Series>& a) { return {a.x.value, a.y.value, a.z.value}; }
inline Vec3 first(const Vector<Series>& a) { return {a.x.first, a.y.first, a.z.first}; }
inline Vec3 second(const Vector<Series>& a) { return {a.x.second, a.y.second, a.z.second}; }

}  // namespace geodrome::test
