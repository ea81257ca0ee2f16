// SPDX-License-Identifier: MIT
#include "tools/shapes/radial.hpp"

#include <cmath>

namespace geodrome::shapes {
namespace {

using std::cos;
using std::sin;

LevelValue bumpy_radius(const Vec3& p) {
  const double sine = sin(3 * p.x + 1), cosine = cos(3 * p.x + 1), even = cos(2 * p.y), odd = sin(2 * p.y);
  const double angle = 4 * p.x * p.z + 0.5, wave = sin(angle), slope = cos(angle);
  const Vec3 turn{4 * p.z, 0, 4 * p.x};
  const Symmetric3 hills{-9 * sine * even, -4 * sine * even, 0, -6 * cosine * odd};
  return {1 + 0.25 * sine * even + 0.15 * wave,
          0.25 * Vec3{3 * cosine * even, -2 * sine * odd, 0} + 0.15 * slope * turn,
          0.25 * hills + 0.15 * (-wave * square(turn) + slope * Symmetric3{.xz = 4})};
}

LevelValue star_radius(const Vec3& p) {
  const auto& [x, y, z] = p;
  return {1 + 0.15 * (x * x * x - 3 * x * y * y) + 0.6 * x * y * z + 0.2 * (z * z - 1.0 / 3),
          0.15 * Vec3{3 * (x * x - y * y), -6 * x * y, 0} + 0.6 * Vec3{y * z, x * z, x * y} + 0.2 * Vec3{0, 0, 2 * z},
          0.15 * Symmetric3{6 * x, -6 * x, 0, -6 * y} + 0.6 * Symmetric3{0, 0, 0, z, y, x} + Symmetric3{.zz = 0.4}};
}

constexpr Radial bodies[] = {{"bumpy", bumpy_radius}, {"star", star_radius}};

}  // namespace

const Radial* find_radial(std::string_view kind) {
  for (const Radial& body : bodies)
    if (body.kind == kind) return &body;
  return nullptr;
}

}  // namespace geodrome::shapes
