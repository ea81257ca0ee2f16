// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/register.hpp"

namespace geodrome {

inline Register<2> both(double first, double second) { return Register<2>::Double{first, second}; }

/// Two images in registers: what is asked of both is computed at once. Every operation is that of a double, so nothing
/// differs from asking them one after the other.
struct ImagePair {
  Register<2> x, y, sigma;

  template <class Image>
  ImagePair(const Image& a, const Image& b) : x(both(a.x, b.x)), y(both(a.y, b.y)), sigma(both(a.sigma, b.sigma)) {}

  /// How far the points (px, 0), one for each or the same, are from the images themselves.
  Register<2> reach(const Register<2>& px) const { return root((px - x) * (px - x) + y * y); }
  /// The distances there.
  Register<2> at(const Register<2>& px) const { return sigma + reach(px); }
};

/// Returns a place in [low, high] at which images a and b are equally far, if a is nearer at one end and b at the
/// other. An `Image` has members x, y, sigma, and `at(x)`, the distance at (x, 0). The formula is used where it holds,
/// otherwise regula falsi (Illinois), which keeps the root between its ends.
template <class Image>
double equal_place(const Image& a, const Image& b, double low, double high) {
  const double formula = bisector_place(a.x, -a.y, a.sigma, b.x, -b.y, b.sigma);
  const double farther = std::max(std::abs(a.sigma), std::abs(b.sigma));
  if (low <= formula && formula <= high) {
    const Register<2> at = ImagePair(a, b).at(formula);
    const double distance = at.v[0];
    if (std::abs(distance - at.v[1]) <= equal_share * std::max(distance, farther)) return formula;
  }
  double at_low = a.at(low) - b.at(low), at_high = a.at(high) - b.at(high);
  int side = 0;
  for (int step = 0;; ++step) {
    const double middle = low + 0.5 * (high - low);
    if (!(low < middle && middle < high)) return middle;
    const double secant = low + (high - low) * (at_low / (at_low - at_high));
    const double x = step < 50 && low < secant && secant < high ? secant : middle;
    const double distance = a.at(x), gap = distance - b.at(x);
    if (std::abs(gap) <= equal_share * std::max(distance, farther)) return x;
    if ((gap < 0) == (at_low < 0)) {
      low = x, at_low = gap;
      if (side == -1) at_high *= 0.5;
      side = -1;
    } else {
      high = x, at_high = gap;
      if (side == 1) at_low *= 0.5;
      side = 1;
    }
  }
}

}  // namespace geodrome
