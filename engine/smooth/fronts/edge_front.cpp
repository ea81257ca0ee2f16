// SPDX-License-Identifier: MIT
#include "engine/smooth/fronts/edge_front.hpp"

#include <cmath>

namespace geodrome {

namespace {

/// The squared distance at an end of a curve, with two derivatives along that.
std::array<double, 3> squared_along(const FrontPoint& at, const CurvePoint& curve) {
  const double slope = dot(at.gradient, curve.first), across = dot(cross(curve.normal, at.gradient), curve.first);
  return {at.distance * at.distance, 2 * at.distance * slope,
          2 * (slope * slope + at.bend * across * across + at.distance * dot(at.gradient, curve.second))};
}

}  // namespace

EdgeFront::EdgeFront(const EdgeCurve& curve, const FrontPoint& from, const FrontPoint& to)
    : curve_(&curve), from_(from.gradient), to_(to.gradient) {
  const auto [a, a1, a2] = squared_along(from, curve.at(0));
  const auto [b, b1, b2] = squared_along(to, curve.at(1));
  const double d = b - a;
  squared_ = {a,
              a1,
              a2 / 2,
              10 * d - 6 * a1 - 4 * b1 - 1.5 * a2 + 0.5 * b2,
              -15 * d + 8 * a1 + 7 * b1 + 1.5 * a2 - b2,
              6 * d - 3 * a1 - 3 * b1 - 0.5 * a2 + 0.5 * b2};
  const double from_cubic = a2 - (6 * d - 4 * a1 - 2 * b1), to_cubic = b2 - (-6 * d + 2 * a1 + 4 * b1);
  doubt_ = (std::abs(from_cubic) + std::abs(to_cubic)) / (64 * (from.distance + to.distance) * curve.length);
}

EdgeFront::Slopes EdgeFront::at(double t) const {
  const auto& c = squared_;
  const double q = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
  const double q1 = c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * 5 * c[5])));
  const double q2 = 2 * c[2] + t * (6 * c[3] + t * (12 * c[4] + t * 20 * c[5]));
  const double value = std::sqrt(q), first = q1 / (2 * value);
  return {value, first, (q2 / 2 - first * first) / value};
}

}  // namespace geodrome
