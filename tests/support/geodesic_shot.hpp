// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "tests/support/series.hpp"

namespace geodrome::test {

/// The length of the geodesic of a shape (analytic_surfaces.hpp) between two of its points that is near to a first
/// guess: its differential equation is integrated, and direction and length are corrected until it ends at `to`. Knows
/// nothing of meshes, nodes and formulas for pieces.
template <class Shape>
class GeodesicShot {
 public:
  explicit GeodesicShot(Shape shape = {}, int steps = 2000) : shape_(shape), steps_(steps) {}

  /// `heading`: a direction that the geodesic starts in, roughly. NaN if it does not get there.
  double length(const Vec3& from, const Vec3& to, const Vec3& heading, double guess) const {
    const Vec3 n = normal(from);
    const Vec3 u = direction(heading - dot(heading, n) * n), v = cross(n, u);
    double angle = 0, length = guess;
    for (int i = 0; i < 30; ++i) {
      const auto shot = [&](double a, double l) { return end(from, std::cos(a) * u + std::sin(a) * v, l); };
      const Vec3 at = shot(angle, length), miss = to - at;
      if (norm(miss) < 1e-12 * length) return length;
      constexpr double h = 1e-5;
      const Vec3 by_angle = (shot(angle + h, length) - shot(angle - h, length)) / (2 * h);
      const Vec3 by_length = (shot(angle, length + h) - shot(angle, length - h)) / (2 * h);
      // Least squares: the miss lies in the tangent plane but for what is of second order.
      const double aa = dot(by_angle, by_angle), al = dot(by_angle, by_length), ll = dot(by_length, by_length);
      const double a = dot(by_angle, miss), l = dot(by_length, miss), det = aa * ll - al * al;
      angle += (a * ll - l * al) / det, length += (aa * l - al * a) / det;
    }
    return NAN;
  }

 private:
  struct State {
    Vec3 x, v;
  };

  static Vec3 direction(const Vec3& a) { return a / norm(a); }
  Vec3 normal(const Vec3& p) const {
    const Vector<double> g = shape_.gradient(Vector<double>{p.x, p.y, p.z});
    return direction({g.x, g.y, g.z});
  }

  /// Along a geodesic only the normal part of the velocity changes: x'' = -(x' . n') n.
  Vec3 acceleration(const Vec3& x, const Vec3& v) const {
    const Vector<Series> n = unit(shape_.gradient(moving(x, v)));
    return -dot(v, first(n)) * value(n);
  }

  /// Runge and Kutta's method of order 4.
  Vec3 end(const Vec3& from, const Vec3& heading, double length) const {
    const double h = length / steps_;
    State s{from, heading};
    const auto slope = [&](const State& at) { return State{at.v, acceleration(at.x, at.v)}; };
    const auto moved = [](const State& at, double k, const State& by) {
      return State{at.x + k * by.x, at.v + k * by.v};
    };
    for (int i = 0; i < steps_; ++i) {
      const State a = slope(s), b = slope(moved(s, h / 2, a)), c = slope(moved(s, h / 2, b)), d = slope(moved(s, h, c));
      s = moved(moved(moved(moved(s, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
    return s.x;
  }

  Shape shape_;
  int steps_;
};

}  // namespace geodrome::test
