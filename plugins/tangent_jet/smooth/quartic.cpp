// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/quartic.hpp"

namespace geodrome {

Eigen::Matrix<double, quartic_size, 1> monomials(double x, double y) {
  const double xx = x * x, xy = x * y, yy = y * y;
  Eigen::Matrix<double, quartic_size, 1> b;
  b << 1, x, y, xx, xy, yy, xx * x, xx * y, x * yy, yy * y, xx * xx, xx * xy, xx * yy, xy * yy, yy * yy;
  return b;
}

Height Quartic::at(double x, double y) const {
  // A polynomial in y, whose coefficients p are polynomials in x with derivatives q and r.
  const double p0 = c[0] + x * (c[1] + x * (c[3] + x * (c[6] + x * c[10])));
  const double p1 = c[2] + x * (c[4] + x * (c[7] + x * c[11]));
  const double p2 = c[5] + x * (c[8] + x * c[12]);
  const double p3 = c[9] + x * c[13];
  const double q0 = c[1] + x * (2 * c[3] + x * (3 * c[6] + x * 4 * c[10]));
  const double q1 = c[4] + x * (2 * c[7] + x * 3 * c[11]);
  const double q2 = c[8] + x * 2 * c[12];
  const double r0 = 2 * c[3] + x * (6 * c[6] + x * 12 * c[10]);
  const double r1 = 2 * c[7] + x * 6 * c[11];
  return {p0 + y * (p1 + y * (p2 + y * (p3 + y * c[14]))),
          q0 + y * (q1 + y * (q2 + y * c[13])),
          p1 + y * (2 * p2 + y * (3 * p3 + y * 4 * c[14])),
          r0 + y * (r1 + y * 2 * c[12]),
          q1 + y * (2 * q2 + y * 3 * c[13]),
          2 * p2 + y * (6 * p3 + y * 12 * c[14])};
}

double Quartic::above(const Vec3& point) const {
  const Vec3 offset = point - base;
  return dot(n, offset) - at(dot(u, offset), dot(v, offset)).z;
}

Vec3 Quartic::normal() const {
  const Vec3 direction = n - c[1] * u - c[2] * v;
  return direction / norm(direction);
}

}  // namespace geodrome
