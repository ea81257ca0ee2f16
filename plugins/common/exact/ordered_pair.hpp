// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "plugins/common/exact/image_pair.hpp"
#include "plugins/common/exact/tolerances.hpp"

namespace geodrome {

/// The part of a half-edge that the rays of an image cross, from `low` to `high` along it.
struct Interval {
  double low, high;
  bool empty() const { return !(low < high); }
};

/// The outcome of settling two images whose rays enter the face below a half-edge in order, left ones first.
enum class PairOrder {
  apart,       ///< nothing was cut: the left interval ends before the right one begins
  cut,         ///< the intervals now end and begin at one place; one of them may have become empty
  drop_left,   ///< no ray of the left image is needed
  drop_right,  ///< no ray of the right image is needed
  tangled      ///< rounding hides which rule applies: only a lower envelope can separate them
};

/// Both exact solvers discard rays by the lemma of ordered neighbours, and by nothing else. It needs no other image and
/// no final distance:
///
///   Let the rays of images L and R enter the face below the half-edge so that those of L enter to the left of those of
///   R. If L is not farther than R at a point x that a ray of L reaches (whether R sees x or not), then no ray of R to
///   the left of x is needed. Likewise with left and right exchanged.
///
/// Proof: the ray of R to y < x and that of L to x cross in the face below, at q. Then |R q| + |q x| >= |R x| >= |L x|
/// = |L q| + |q x|, so L is at q no farther than R, and the ray of R is not shortest beyond q, or tied. (Chen and Han's
/// "one angle, one split" is the case of x at a vertex.)
///
/// An `Image` has members `x`, `y` <= 0 and `sigma` in the frame of the half-edge, `at(x)`, the distance of (x, 0), and
/// `to(x, y)`, that of any point.

/// Settles an ordered pair of which every ray of the left image meets the half-edge at or after `left_low`, and every
/// ray of the right image at or before `right_high` <= `left_low`: the rays have changed sides in the face below. The
/// lemma, with the point where the two nearest rays cross for x, drops the image that is farther there. Images that tie
/// there decide nothing unless the rays cross at an angle by which the way over the crossing is longer than a straight
/// one; if they cross in the place of an image, which is a vertex, there may be no straight one. An image is dropped
/// only where the other one is nearer at the end of its own ray, if rounding has moved the crossing off the rays. O(1).
template <class Image>
PairOrder settle_reversed_pair(const Image& left, double left_low, const Image& right, double right_high) {
  const double ux = left_low - left.x, uy = -left.y, vx = right_high - right.x, vy = -right.y;
  const double wx = right.x - left.x, wy = right.y - left.y, turn = ux * vy - uy * vx;
  const double along_left = (wx * vy - wy * vx) / turn, along_right = (wx * uy - wy * ux) / turn;
  if (0 <= along_left && along_left <= 1 && 0 <= along_right && along_right <= 1) {
    const double qx = left.x + along_left * ux, qy = left.y + along_left * uy;
    const double of_left = left.to(qx, qy), of_right = right.to(qx, qy);
    if (nearer(of_left, of_right)) return PairOrder::drop_right;
    if (nearer(of_right, of_left)) return PairOrder::drop_left;
    if (std::min(along_left, along_right) > close_share && nearer(left.at(right_high), right.at(right_high)))
      return PairOrder::drop_right;
  } else {
    if (nearer(left.at(left_low), right.at(left_low))) return PairOrder::drop_right;
    if (nearer(right.at(right_high), left.at(right_high))) return PairOrder::drop_left;
  }
  return PairOrder::tangled;
}

/// Cuts the intervals `l` and `r` of an ordered pair against each other by the lemma, with nothing else known. An
/// interval is never cut for the sake of one inside it while the two images are equally far up to rounding, as along
/// the ray from one through the other: no other image would cover what rounding took away. O(1) but for `equal_place`.
template <class Image>
PairOrder settle_pair(const Image& left, Interval& l, const Image& right, Interval& r) {
  if (l.empty()) return PairOrder::drop_left;
  if (r.empty()) return PairOrder::drop_right;
  if (l.high <= r.low) return PairOrder::apart;
  const double low = std::max(l.low, r.low), high = std::min(l.high, r.high);
  if (!(low < high)) return settle_reversed_pair(left, l.low, right, r.high);
  const ImagePair images(left, right);
  const Register<2> at_high = images.at(high), at_low = images.at(low);
  const bool left_keeps_all = !nearer(at_high.v[1], at_high.v[0]);
  const bool right_keeps_all = !nearer(at_low.v[0], at_low.v[1]);
  const bool left_is_inside = r.low < low;
  // Equally far everywhere, but with the right interval on the left: the lemma needs one image to be nearer.
  if (left_keeps_all && right_keeps_all && left_is_inside && high < l.high) return PairOrder::tangled;
  if (left_keeps_all && !(right_keeps_all && left_is_inside))
    r.low = high;
  else if (right_keeps_all)
    l.high = low;
  else
    l.high = r.low = equal_place(left, right, low, high);
  return PairOrder::cut;
}

}  // namespace geodrome
