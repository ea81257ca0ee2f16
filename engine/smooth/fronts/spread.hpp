// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace geodrome {

/// How geodesics from one point that start side by side spread: how far they are apart, and the slope of that along
/// them. Their ratio is the geodesic curvature of the circle around the point.
struct Spread {
  double apart = 1, slope = 0;

  /// After a piece, by the Gaussian curvature at its begin, middle and end: Jacobi's equation apart'' = -K apart, by a
  /// step of Nystrom's method of order 4. Beyond a conjugate point `apart` is no longer positive.
  Spread after(double length, const std::array<double, 3>& curvature) const {
    const double a = -curvature[0] * apart;
    const double b = -curvature[1] * (apart + length / 2 * slope + length * length / 8 * a);
    const double c = -curvature[2] * (apart + length * slope + length * length / 2 * b);
    return {apart + length * (slope + length / 6 * (a + 2 * b)), slope + length / 6 * (a + 4 * b + c)};
  }
};

}  // namespace geodrome
