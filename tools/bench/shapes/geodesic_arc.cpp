// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/geodesic_arc.hpp"

#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <functional>

#include "geodrome/errors.hpp"

namespace geodrome::bench {
namespace {

namespace odeint = boost::numeric::odeint;

/// x, x', and value and slope of the two Jacobi fields.
using State = std::array<double, 10>;

using Fehlberg = odeint::runge_kutta_fehlberg78<State>;
using Checker = odeint::default_error_checker<double, odeint::array_algebra, odeint::default_operations>;

Vec3 position(const State& y) { return {y[0], y[1], y[2]}; }
Vec3 velocity(const State& y) { return {y[3], y[4], y[5]}; }

void derivative(LevelSet level, const State& y, State& result) {
  const LevelValue f = level(position(y));
  const Vec3 along = velocity(y), bent = f.hessian * along;
  const double square = squared_norm(f.gradient), push = -dot(along, bent) / square;
  const Vec3 across = cross(f.gradient, along);  // |grad f| long
  const double twist = dot(across, bent);
  const double gauss = (-push * dot(across, f.hessian * across) - twist * twist / square) / square;
  result = {along.x, along.y,       along.z, push * f.gradient.x, push * f.gradient.y, push * f.gradient.z,
            y[7],    -gauss * y[6], y[9],    -gauss * y[8]};
}

}  // namespace

Vec3 normal_at(LevelSet level, const Vec3& point) {
  const Vec3 gradient = level(point).gradient;
  return gradient / norm(gradient);
}

GeodesicArc shoot(LevelSet level, const Vec3& from, const Vec3& direction, double length) {
  constexpr double tolerance = 1e-14;  // of a step, near rounding: the shapes have size 1
  State y{from.x, from.y, from.z, direction.x, direction.y, direction.z, 0, 1, 1, 0};
  const auto slope = [level](const State& at, State& result, double) { derivative(level, at, result); };
  static const Fehlberg method;  // its buffers are copied, so that they must have values
  odeint::controlled_runge_kutta<Fehlberg> stepper(Checker(tolerance, tolerance), {}, method);
  odeint::integrate_adaptive(std::ref(stepper), slope, y, 0.0, length, length / 4);
  return {length, position(y), direction, velocity(y) / norm(velocity(y)), {y[6], y[7]}, {y[8], y[9]}};
}

GeodesicArc connect(LevelSet level, const Vec3& from, const Vec3& to) {
  constexpr int most_rounds = 30;
  constexpr double settled = 1e-9;  // the next error is of the order of its square
  const Vec3 normal = normal_at(level, from), chord = to - from, flat = chord - dot(chord, normal) * normal;
  double length = norm(chord);
  Vec3 direction = flat / norm(flat);
  for (int round = 0; round < most_rounds; ++round) {
    GeodesicArc arc = shoot(level, from, direction, length);
    const Vec3 miss = to - arc.end, across = cross(normal_at(level, arc.end), arc.arriving);
    const double behind = dot(miss, arc.arriving), beside = dot(miss, across);
    arc.length = length += behind;
    if (std::abs(behind) + std::abs(beside) < settled) return arc;
    const double turn = beside / arc.turned.value;
    direction = std::cos(turn) * direction + std::sin(turn) * cross(normal, direction);
    if (!(length > 0 && std::abs(turn) < 1)) break;
  }
  throw NumericalError("no geodesic was found between two near points");
}

}  // namespace geodrome::bench
