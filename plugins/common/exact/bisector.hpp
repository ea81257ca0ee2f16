// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodrome {

// This header is also compiled for processors that not everybody has. So everything here is static, or a template that
// code for such a processor uses with types of its own: no copy made for one processor is linked into the code for
// another.

/// Two distances along a path are equal if they differ by less than this share of them: a few roundings.
inline constexpr double equal_share = 8 * std::numeric_limits<double>::epsilon();

/// Tells whether distance a is shorter than b by more than rounding.
static inline bool nearer(double a, double b) { return a < b - equal_share * b; }

// Give doubles the operations that registers of doubles have.
static inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
static inline double root(double v) { return std::sqrt(v); }

/// Returns the x at which the line y = 0 meets the bisector of two images: points p = (x, 0) with |p - g1| + s1 = |p -
/// g2| + s2; h1 and h2 are the heights of the line above the images. The result is any value, or NaN, if they do not
/// meet: check it.
///
/// With w = g2 - g1, s = s2 - s1, c = w^2 - s^2, beta = w_y h1 - c/2 and Q = sqrt(c (4 h1 h2 + c)) / 2 the root of the
/// quadratic equation for t = x - x1 at which image 2 becomes the nearer one is t = (s Q - w_x beta) / (w_x^2 - s^2) =
/// (s^2 h1^2 - beta^2) / (s Q + w_x beta), of which the form that does not cancel is used. `Number` is double or a
/// register of doubles.
template <class Number>
Number bisector_place(const Number& x1, const Number& h1, const Number& s1, const Number& x2, const Number& h2,
                      const Number& s2) {
  const Number wx = x2 - x1, wy = h1 - h2, s = s2 - s1;
  const Number c = wx * wx + wy * wy - s * s, beta = wy * h1 - 0.5 * c, zero{};
  const Number inner = c * (4.0 * h1 * h2 + c), sq = 0.5 * s * root(select(inner > zero, inner, zero));
  const Number wb = wx * beta, sh = s * h1;
  const auto same_sign = sq * wb > zero;
  const Number above = select(same_sign, (sh - beta) * (sh + beta), sq - wb);
  const Number below = select(same_sign, sq + wb, wx * wx - s * s);
  return x1 + above / below;
}

/// Returns a place in [low, high] at which images a and b are equally far, if a is nearer at one end and b at the
/// other. An `Image` has members x, y, sigma, and `at(x)`, the distance at (x, 0). The formula is used where it holds,
/// otherwise regula falsi (Illinois), which keeps the root between its ends.
template <class Image>
double equal_place(const Image& a, const Image& b, double low, double high) {
  const double formula = bisector_place(a.x, -a.y, a.sigma, b.x, -b.y, b.sigma);
  const double farther = std::max(std::abs(a.sigma), std::abs(b.sigma));
  if (low <= formula && formula <= high) {
    const double distance = a.at(formula);
    if (std::abs(distance - b.at(formula)) <= equal_share * std::max(distance, farther)) return formula;
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
