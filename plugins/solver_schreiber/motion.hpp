// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

namespace geodrome::schreiber {

/// A rigid motion of the plane: a rotation about the origin, then a shift.
struct Motion {
  double cosine = 1, sine = 0, x = 0, y = 0;

  std::pair<double, double> turn(double px, double py) const {
    return {cosine * px - sine * py, sine * px + cosine * py};
  }
  std::pair<double, double> turn_back(double px, double py) const {
    return {cosine * px + sine * py, cosine * py - sine * px};
  }
  std::pair<double, double> operator()(double px, double py) const {
    const auto [tx, ty] = turn(px, py);
    return {tx + x, ty + y};
  }

  /// Composes two motions: `b` first, then `a`. The rotation is brought back to length 1, so that many motions in a row
  /// stay rigid.
  friend Motion operator*(const Motion& a, const Motion& b) {
    const auto [cosine, sine] = a.turn(b.cosine, b.sine);
    const auto [x, y] = a(b.x, b.y);
    const double longer = 1.5 - 0.5 * (cosine * cosine + sine * sine);
    return {cosine * longer, sine * longer, x, y};
  }

  Motion inverse() const {
    const Motion back{cosine, -sine, 0, 0};
    const auto [bx, by] = back.turn(x, y);
    return {cosine, -sine, -bx, -by};
  }
};

}  // namespace geodrome::schreiber
