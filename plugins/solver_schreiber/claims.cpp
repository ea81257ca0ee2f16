// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/claims.hpp"

#include <algorithm>

#include "plugins/common/exact/image_pair.hpp"

namespace geodrome::schreiber {

namespace {

/// Tells whether `g` is not farther than `other` where its line to p crosses a ray (dx, dy) of the other one.
bool is_near_at_ray(const Generator& g, const Generator& other, double dx, double dy, double px, double py) {
  const double ux = px - g.x, uy = py - g.y, gap_x = g.x - other.x, gap_y = g.y - other.y;
  const double turn = dx * uy - dy * ux;
  const double along = (gap_x * uy - gap_y * ux) / turn;  // the ray
  if (!(along > 0)) return true;                          // not in front of it
  const double qx = other.x + along * dx, qy = other.y + along * dy;
  return !nearer(other.sigma + along, g.to(qx, qy));
}

}  // namespace

bool right_has(const Generator& left, const Generator& right, double px, double py) {
  if (!right.reaches_low(px, py)) return false;
  if (!left.reaches_high(px, py)) return true;
  const bool in_left = left.inside_low(px, py), in_right = right.inside_high(px, py);
  if (in_right && !in_left) return is_near_at_ray(right, left, left.low_x, left.low_y, px, py);
  if (in_left && !in_right) return !is_near_at_ray(left, right, right.high_x, right.high_y, px, py);
  if (in_left && in_right) return right.to(px, py) < left.to(px, py);
  // Before the point the two have changed sides: what counts is which is nearer where their outermost rays cross.
  return !is_near_at_ray(left, right, right.high_x, right.high_y, left.x + left.low_x, left.y + left.low_y);
}

void keep_left(const Generator& left, Interval& l, const Generator& gone, const Interval& r) {
  const double low = std::max(l.low, r.low), high = std::min(l.high, r.high);
  if (!(low < high) || !nearer(gone.at(high), left.at(high))) return;
  l.high = nearer(left.at(low), gone.at(low)) ? equal_place(left, gone, low, high) : low;
}

void keep_right(const Generator& gone, const Interval& l, const Generator& right, Interval& r) {
  const double low = std::max(l.low, r.low), high = std::min(l.high, r.high);
  if (!(low < high) || !nearer(gone.at(low), right.at(low))) return;
  r.low = nearer(right.at(high), gone.at(high)) ? equal_place(gone, right, low, high) : high;
}

}  // namespace geodrome::schreiber
