// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "geodrome/geometry.hpp"

/// What the generated shapes are, written down a second time, from their definitions and not from the generator's code.
namespace geodrome::test {

inline Vec3 trefoil_curve(double t) {
  return {(std::sin(t) + 2 * std::sin(2 * t)) / 3, (std::cos(t) - 2 * std::cos(2 * t)) / 3, -std::sin(3 * t) / 3};
}

/// Distance to the trefoil: a scan, then golden-section search between the best one's neighbours.
inline double distance_to_trefoil(const Vec3& p) {
  constexpr int scan = 400;
  constexpr double step = 2 * std::numbers::pi / scan, ratio = 1 / std::numbers::phi;
  const auto gap = [&](double t) { return squared_distance(p, trefoil_curve(t)); };
  int best = 0;
  for (int i = 1; i < scan; ++i)
    if (gap(i * step) < gap(best * step)) best = i;
  double low = (best - 1) * step, high = (best + 1) * step;
  while (high - low > 1e-8) {  // the distance is flat at its minimum: its error is the square of this
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    (gap(a) < gap(b) ? high : low) = gap(a) < gap(b) ? b : a;
  }
  return std::sqrt(gap(0.5 * (low + high)));
}

inline double genus2_value(const Vec3& p) {
  const double g = p.x * p.x - p.x * p.x * p.x * p.x - p.y * p.y;
  return g * g + p.z * p.z - 0.03;
}

inline double genus5_value(const Vec3& p) {
  double sum = p.x * p.x + p.y * p.y + 4 * p.z * p.z - 1;
  for (int k = 0; k < 5; ++k) {
    const double angle = 2 * std::numbers::pi * k / 5;
    sum +=
        1.3 * std::exp(-25 * (std::pow(p.x - 0.55 * std::cos(angle), 2) + std::pow(p.y - 0.55 * std::sin(angle), 2)));
  }
  return sum;
}

inline double bumpy_radius(const Vec3& d) {
  return 1 + 0.25 * std::sin(3 * d.x + 1) * std::cos(2 * d.y) + 0.15 * std::sin(4 * d.x * d.z + 0.5);
}

inline double star_radius(const Vec3& d) {
  const double three = std::pow(std::hypot(d.x, d.y), 3) * std::cos(3 * std::atan2(d.y, d.x));
  return 1 + 0.15 * three + 0.6 * d.x * d.y * d.z + 0.2 * (d.z * d.z - 1.0 / 3);
}

/// The spiral r = t, by the nearest of its turns; positive towards its centre.
inline double spiral_value(const Vec3& p) {
  const double r = std::hypot(p.x, p.z), angle = std::atan2(p.z, p.x);
  double best = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < 4; ++turn) {
    const double gap = r - (angle + 2 * std::numbers::pi * turn);
    if (std::abs(gap) < std::abs(best)) best = gap;
  }
  return -best;
}

/// A function of known sign (negative inside) that is 0 on the shape; the plane and the cut shapes as if not cut.
inline double shape_value(const std::string& kind, const Vec3& p) {
  if (kind == "sphere" || kind == "cut-sphere") return norm(p) - 1;
  if (kind == "ellipsoid") return norm({p.x, p.y / 0.8, p.z / 0.6}) - 1;
  if (kind == "torus" || kind == "cut-torus") return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4;
  if (kind == "trefoil") return distance_to_trefoil(p) - 0.1;
  if (kind == "bumpy") return norm(p) - bumpy_radius(p / norm(p));
  if (kind == "star") return norm(p) - star_radius(p / norm(p));
  if (kind == "genus2") return genus2_value(p);
  if (kind == "genus5") return genus5_value(p);
  if (kind == "swiss-roll") return spiral_value(p);
  if (kind == "s-curve") return p.z <= 0 ? std::hypot(p.x, p.z + 1) - 1 : 1 - std::hypot(p.x, p.z - 1);
  if (kind == "slit-pipe") return std::hypot(p.x, p.y) - 1;
  return p.z;
}

/// Its gradient, by central differences.
inline Vec3 shape_gradient(const std::string& kind, const Vec3& p) {
  constexpr double h = 1e-5;
  const auto slope = [&](const Vec3& d) {
    return (shape_value(kind, p + h * d) - shape_value(kind, p - h * d)) / (2 * h);
  };
  return {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
}

/// Distance from the shape, to first order, which is enough to tell 0 from 1e-12.
inline double distance_off_shape(const std::string& kind, const Vec3& p) {
  return std::abs(shape_value(kind, p)) / norm(shape_gradient(kind, p));
}

/// Whether the shape has not ended before the point.
inline bool within_borders(const std::string& kind, const Vec3& p) {
  constexpr double rounding = 1e-12;
  if (kind == "cut-sphere") return p.z <= 0.5 + rounding;
  if (kind == "cut-torus") return p.z <= 0.2 + rounding;
  if (kind == "plane") return p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1;
  const double r = std::hypot(p.x, p.z);
  if (kind == "swiss-roll")
    return p.y >= 0 && p.y <= 21 && r >= 1.5 * std::numbers::pi - rounding && r <= 4.5 * std::numbers::pi + rounding;
  if (kind == "s-curve")  // a quarter of either circle is missing
    return p.y >= 0 && p.y <= 2 &&
           (p.z <= 0 ? p.x >= -rounding || p.z <= -1 + rounding : p.x <= rounding || p.z >= 1 - rounding);
  if (kind == "slit-pipe") return p.z >= 0 && p.z <= 4 && std::abs(std::atan2(p.y, p.x)) >= 0.375 - rounding;
  return true;
}

}  // namespace geodrome::test
