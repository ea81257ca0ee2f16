// SPDX-License-Identifier: MIT
#include "tools/shapes/patch.hpp"

#include <cmath>
#include <numbers>

#include "tools/shapes/radial.hpp"
#include "tools/shapes/sheets.hpp"

namespace geodrome::shapes {
namespace {

using std::cos;
using std::sin;
constexpr double pi = std::numbers::pi;

/// The part of an ellipsoid between two latitudes.
PatchPoint on_ellipsoid(const Vec3& semi_axes, double south, double north, double u, double v) {
  const double longitude = 2 * pi * u, latitude = south + (north - south) * v;
  const auto& [a, b, c] = semi_axes;
  const double x = cos(latitude) * cos(longitude), y = cos(latitude) * sin(longitude), z = sin(latitude);
  const double scale = 2 * pi * (north - south) * cos(latitude);
  return {{a * x, b * y, c * z}, scale * Vec3{b * c * x, a * c * y, a * b * z}};
}

/// By longitude and latitude of the direction d; with g the radius's gradient along the sphere, du x dv of R(d) d is
/// that of d times R (R d - g).
PatchPoint on_radial(std::string_view kind, double u, double v) {
  const auto [d, area] = on_ellipsoid({1, 1, 1}, -pi / 2, pi / 2, u, v);
  const LevelValue radius = find_radial(kind)->radius(d);
  const Vec3 along = radius.gradient - dot(radius.gradient, d) * d;
  return {radius.value * d, norm(area) * radius.value * (radius.value * d - along)};
}

constexpr double ring = 1, tube = 0.4;

/// The part of the torus between two angles around its tube; angle 0 is farthest from the axis.
PatchPoint on_torus(double low, double high, double u, double v) {
  const double around = 2 * pi * u, angle = low + (high - low) * v;
  const Vec3 normal{cos(angle) * cos(around), cos(angle) * sin(around), sin(angle)};
  const Vec3 centre{ring * cos(around), ring * sin(around), 0};
  const double scale = 2 * pi * (high - low) * tube * (ring + tube * cos(angle));
  return {centre + tube * normal, scale * normal};
}

constexpr double rope = 0.1;

/// The trefoil's tube, in the Frenet frame of its curve, whose curvature is nowhere 0.
PatchPoint on_trefoil(double u, double v) {
  const double t = 2 * pi * u, angle = 2 * pi * v;
  const Vec3 centre = Vec3{sin(t) + 2 * sin(2 * t), cos(t) - 2 * cos(2 * t), -sin(3 * t)} / 3;
  const Vec3 first = Vec3{cos(t) + 4 * cos(2 * t), -sin(t) + 4 * sin(2 * t), -3 * cos(3 * t)} / 3;
  const Vec3 second = Vec3{-sin(t) - 8 * sin(2 * t), -cos(t) + 8 * cos(2 * t), 9 * sin(3 * t)} / 3;
  const Vec3 turn = cross(first, second);
  const double speed = norm(first), curvature = norm(turn) / (speed * speed * speed);
  const Vec3 tangent = first / speed, binormal = turn / norm(turn);
  const Vec3 normal = cos(angle) * cross(binormal, tangent) - sin(angle) * binormal;
  return {centre + rope * normal, 4 * pi * pi * rope * speed * (1 - rope * curvature * cos(angle)) * normal};
}

constexpr Patch patches[] = {
    {"sphere",
     [](double u, double v) {
       return on_ellipsoid({1, 1, 1}, -pi / 2, pi / 2, u, v);
     },
     true, End::pole, End::pole, 2 * pi* pi, 2},
    // The largest product of two semi-axes bounds the area element.
    {"ellipsoid",
     [](double u, double v) {
       return on_ellipsoid({1, 0.8, 0.6}, -pi / 2, pi / 2, u, v);
     },
     true, End::pole, End::pole, 2 * pi* pi * 0.8, 2.2},
    {"torus", [](double u, double v) { return on_torus(0, 2 * pi, u, v); }, true, End::wrap, End::wrap,
     4 * pi* pi* tube*(ring + tube), 2.5},
    // Speed squared is (17 + 8 cos 3t) / 9 + cos^2 3t <= 34 / 9; the length is 9.61.
    {"trefoil", on_trefoil, true, End::wrap, End::wrap, 4 * pi* pi* rope * 1.944 * (1 + rope * 2.34), 15.3},
    // |R| <= 1.4 and |g| <= 1.5 by the sizes of the terms.
    {"bumpy", [](double u, double v) { return on_radial("bumpy", u, v); }, true, End::pole, End::pole,
     2 * pi* pi * 2.88, 2},
    // |R| <= 1.4 and |g| <= 1.
    {"star", [](double u, double v) { return on_radial("star", u, v); }, true, End::pole, End::pole, 2 * pi* pi * 2.41,
     2},
    {"plane",
     [](double u, double v) {
       return PatchPoint{{u, v, 0}, {0, 0, 1}};
     },
     false, End::border, End::border, 1, 1},
    {"cut-sphere",
     [](double u, double v) {
       return on_ellipsoid({1, 1, 1}, -pi / 2, pi / 6, u, v);
     },
     true, End::pole, End::border, 2 * pi*(2 * pi / 3), 3},
    // sin(angle) <= 1/2, so that z = 0.4 sin(angle) <= 1/5.
    {"cut-torus", [](double u, double v) { return on_torus(5 * pi / 6, 13 * pi / 6, u, v); }, true, End::border,
     End::border, 2 * pi*(4 * pi / 3) * tube*(ring + tube), 3.75},
    // sqrt(1 + t^2) is largest where the roll ends, at t = 4.5 pi.
    {"swiss-roll", on_swiss_roll, false, End::border, End::border, 3 * pi * 21 * 14.18, 4.26},
    {"s-curve", on_s_curve, false, End::border, End::border, 6 * pi, 4.71},
    {"slit-pipe", on_slit_pipe, false, End::border, End::border, (2 * pi - 0.75) * 4, 1.38},
};

}  // namespace

const Patch* find_patch(std::string_view kind) {
  for (const Patch& patch : patches)
    if (patch.kind == kind) return &patch;
  return nullptr;
}

}  // namespace geodrome::shapes
