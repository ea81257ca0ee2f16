// SPDX-License-Identifier: MIT
#include "tools/shapes/sheets.hpp"

#include <cmath>
#include <numbers>

#include "geodrome/errors.hpp"

namespace geodrome::shapes {
namespace {

constexpr double roll_begin = 1.5 * std::numbers::pi, roll_turn = 3 * std::numbers::pi, roll_height = 21;
constexpr double s_turn = 3 * std::numbers::pi, s_height = 2;
constexpr double pipe_slit = 0.75, pipe_turn = 2 * std::numbers::pi - pipe_slit, pipe_length = 4;

/// The length of the spiral r = t from its centre.
double spiral_length(double t) { return 0.5 * (t * std::sqrt(1 + t * t) + std::asinh(t)); }

/// The parameter of the turn that is nearest to (x, z).
double spiral_parameter(double x, double z) {
  const double angle = std::atan2(z, x);
  return angle + 2 * std::numbers::pi * std::round((std::hypot(x, z) - angle) / (2 * std::numbers::pi));
}

double s_parameter(double x, double z) {
  const double sign = z <= 0 ? 1 : -1;
  const double t = std::atan2(sign * x, 1 + sign * z);
  // The end of either half goes on where the angle jumps: half a turn more than half a turn.
  return sign * (t < -0.25 * std::numbers::pi ? t + 2 * std::numbers::pi : t);
}

}  // namespace

PatchPoint on_swiss_roll(double u, double v) {
  const double t = roll_begin + roll_turn * u;
  const Vec3 along{std::cos(t) - t * std::sin(t), 0, std::sin(t) + t * std::cos(t)};
  return {{t * std::cos(t), roll_height * v, t * std::sin(t)}, roll_turn * roll_height * Vec3{-along.z, 0, along.x}};
}

PatchPoint on_s_curve(double u, double v) {
  const double t = s_turn * (u - 0.5), sign = t < 0 ? -1 : 1;
  return {{std::sin(t), s_height * v, sign * (std::cos(t) - 1)},
          s_turn * s_height * Vec3{sign * std::sin(t), 0, std::cos(t)}};
}

PatchPoint on_slit_pipe(double u, double v) {
  const double angle = 0.5 * pipe_slit + pipe_turn * u;
  const Vec3 normal{std::cos(angle), std::sin(angle), 0};
  return {normal + Vec3{0, 0, pipe_length * v}, pipe_turn * pipe_length * normal};
}

const std::vector<std::string>& sheet_kinds() {
  static const std::vector<std::string> kinds{"plane", "swiss-roll", "s-curve", "slit-pipe"};
  return kinds;
}

UnrolledPoint unrolled(const std::string& kind, const Vec3& p) {
  if (kind == "plane") return {p.x, p.y};
  if (kind == "swiss-roll") return {spiral_length(spiral_parameter(p.x, p.z)), p.y};
  if (kind == "s-curve") return {s_parameter(p.x, p.z), p.y};
  if (kind == "slit-pipe") {
    const double angle = std::atan2(p.y, p.x);
    return {angle < 0 ? angle + 2 * std::numbers::pi : angle, p.z};
  }
  throw OptionError("'" + kind + "' cannot be unrolled", "valid shapes: plane, swiss-roll, s-curve, slit-pipe");
}

double sheet_distance(const std::string& kind, const Vec3& a, const Vec3& b) {
  const UnrolledPoint p = unrolled(kind, a), q = unrolled(kind, b);
  return std::hypot(p.along - q.along, p.across - q.across);
}

}  // namespace geodrome::shapes
