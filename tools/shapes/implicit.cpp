// SPDX-License-Identifier: MIT
#include "tools/shapes/implicit.hpp"

#include <cmath>
#include <numbers>

#include "geodrome/errors.hpp"

namespace geodrome::shapes {
namespace {

LevelValue double_torus(const Vec3& p) {
  const double xx = p.x * p.x, g = xx - xx * xx - p.y * p.y;
  const Vec3 slope{2 * p.x - 4 * p.x * xx, -2 * p.y, 0};
  return {g * g + p.z * p.z - 0.03,
          {2 * g * slope.x, -4 * g * p.y, 2 * p.z},
          2 * square(slope) + 2 * g * Symmetric3{2 - 12 * xx, -2} + Symmetric3{0, 0, 2}};
}

LevelValue five_holes(const Vec3& p) {
  constexpr double height = 1.3, sharpness = 25, circle = 0.55;
  // cos and sin of 2 pi k / 5
  constexpr double x[] = {1, 0.30901699437494742, -0.80901699437494742, -0.80901699437494742, 0.30901699437494742};
  constexpr double y[] = {0, 0.95105651629515357, 0.58778525229247313, -0.58778525229247313, -0.95105651629515357};
  LevelValue f{p.x * p.x + p.y * p.y + 4 * p.z * p.z - 1, {2 * p.x, 2 * p.y, 8 * p.z}, {2, 2, 8}};
  for (int k = 0; k < 5; ++k) {
    const double dx = p.x - circle * x[k], dy = p.y - circle * y[k];
    const double hill = height * std::exp(-sharpness * (dx * dx + dy * dy));
    f.value += hill;
    f.gradient = f.gradient - 2 * sharpness * hill * Vec3{dx, dy, 0};
    f.hessian = f.hessian + 2 * sharpness * hill * (2 * sharpness * square({dx, dy, 0}) + Symmetric3{-1, -1});
  }
  return f;
}

constexpr Implicit surfaces[] = {
    // x^4 - x^2 <= sqrt(0.03) gives |x| < 1.073; y^2 <= 1/4 + sqrt(0.03) gives |y| < 0.651; |z| <= 0.1733. In the box
    // |grad g|^2 <= 11.7, |g| <= 0.75 and |Hess g| <= 12.6, so the second derivative of g^2 is at most 42.3.
    {"genus2", double_torus, {1.1, 0.68, 0.2}, 45, 0.12, 2},
    // One hill's second derivative is at most 65 (its centre), and less than 29 at distance 0.2 and beyond; the centres
    // are
    // 0.64 apart, so that all five together stay below 73; the paraboloid adds 2 in x and y.
    {"genus5", five_holes, {1.02, 1.02, 0.52}, 76, 0.1, 5},
};

}  // namespace

const Implicit* find_implicit(std::string_view kind) {
  for (const Implicit& surface : surfaces)
    if (surface.kind == kind) return &surface;
  return nullptr;
}

Vec3 project(const Implicit& surface, Vec3 point) {
  constexpr int most_steps = 100;
  constexpr double settled = 1e-15;  // the shapes have size 1
  for (int step = 0; step < most_steps; ++step) {
    const LevelValue f = surface.at(point);
    const Vec3 move = (f.value / squared_norm(f.gradient)) * f.gradient;
    point = point - move;
    if (!(norm(move) > settled)) return point;
  }
  throw NumericalError(std::string(surface.kind) + ": a point did not settle on the surface");
}

}  // namespace geodrome::shapes
