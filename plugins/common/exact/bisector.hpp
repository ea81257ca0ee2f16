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

}  // namespace geodrome
