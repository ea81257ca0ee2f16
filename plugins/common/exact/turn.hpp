// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/mesh/apex.hpp"

namespace geodrome {

// Compiled for processors that not everybody has as well, as bisector.hpp is.

/// How images and intervals pass from a half-edge to another edge of its face: a rotation about the point `pivot` of
/// the half-edge, then a shift along the new one, `limit` long.
struct Turn {
  double pivot, cosine, sine, shift, limit;
  double away;  ///< where the end of an interval goes whose line never meets the new edge: 0 or `limit`
};

/// To the frame of the half-edge beyond the edge on the left or right of the apex.
static inline Turn turn_left(const Apex& apex) {
  const double limit = apex.left_length();
  return {0, apex.face.cosine[apex.a], apex.face.sine[apex.a], 0, limit, limit};
}
static inline Turn turn_right(const Apex& apex) {
  const double limit = apex.right_length();
  return {apex.length, apex.face.cosine[apex.b], -apex.face.sine[apex.b], limit, limit, 0};
}

/// Images are rotated once for each face that is crossed; their error stays below this share of their distance.
inline constexpr double image_share = 1e-13;

static inline double least(double a, double b) { return a < b ? a : b; }
static inline double most(double a, double b) { return a > b ? a : b; }

/// An image (px, py) after a turn, and the ends of its interval. `Number` is double or a register of doubles. On the
/// line of the new edge, but for rounding, an image is put on it; beyond it, it sees the edge from behind, which a
/// window as short as its own rounding can seem to do: its ends change places, so that it is empty.
template <class Number>
class TurnedImage {
 public:
  TurnedImage(const Turn& turn, const Number& px, const Number& py)
      : cosine_(turn.cosine),
        sine_(turn.sine),
        pivot_(turn.pivot),
        shift_(turn.shift),
        limit_(turn.limit),
        away_(turn.away) {
    const Number out = px - pivot_, computed = cosine_ * py - sine_ * out;
    x_ = cosine_ * out + sine_ * py + shift_;
    behind_ = computed > Number(image_share) * (most(out, -out) + most(py, -py));
    y_ = least(computed, Number{});
  }

  const Number& x() const { return x_; }
  const Number& y() const { return y_; }
  Number low(const Number& end) const { return onward(end, limit_); }
  Number high(const Number& end) const { return onward(end, Number{}); }

 private:
  /// Where the line from the image through the end of the interval goes on to y = 0.
  Number onward(const Number& end, const Number& if_behind) const {
    const Number zero{}, p = end - pivot_, qx = cosine_ * p + shift_, down = sine_ * p, climb = -down - y_;
    const Number met = qx + (qx - x_) * down / climb, missed = select(down > zero, away_, qx);
    return most(least(select(behind_, if_behind, select(climb > zero, met, missed)), limit_), zero);
  }

  Number cosine_, sine_, pivot_, shift_, limit_, away_, x_{}, y_{};
  decltype(std::declval<Number>() > std::declval<Number>()) behind_{};
};

/// Above 0 where the line from image (ix, iy) through (px, 0) leaves the point (x, y) on its left, below where on its
/// right. An image on the line y = 0 counts as just below it, so that a point on that line has a side too.
template <class Number>
Number side_of_line(const Number& ix, const Number& iy, const Number& px, double x, double y) {
  const Number below = iy - 1e-300;
  return (px - ix) * (y - below) + below * (x - ix);
}

}  // namespace geodrome
