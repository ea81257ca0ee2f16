// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/claims.hpp"

#include <algorithm>

#include "plugins/common/exact/bisector.hpp"

namespace geodrome::schreiber {

namespace {

/// Whether `g` is not farther than `other` where its line to p crosses a ray (dx, dy) of the other one.
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

/// Where the outermost two rays cross, at q, one is not farther, and no ray of the other is needed from there on (the
/// lemma of FrontEditor, with q for x).
Order settle_reversed(const Generator& left, double left_low, const Generator& right, double right_high) {
  const double ux = left_low - left.x, uy = -left.y, vx = right_high - right.x, vy = -right.y;
  const double turn = ux * vy - uy * vx;
  const double share = ((right.x - left.x) * vy - (right.y - left.y) * vx) / turn;
  const bool crosses = share >= 0 && share <= 1;
  const double s = crosses ? share : 1;
  const double qx = left.x + s * ux, qy = left.y + s * uy;
  const double of_left = left.to(qx, qy), of_right = right.to(qx, qy);
  if (nearer(of_left, of_right)) return Order::drop_right;
  if (nearer(of_right, of_left)) return Order::drop_left;
  return crosses ? Order::drop_right : Order::apart;
}

Order settle(const Generator& left, Claim& l, const Generator& right, Claim& r) {
  if (l.empty()) return Order::drop_left;
  if (r.empty()) return Order::drop_right;
  if (l.high <= r.low) return Order::apart;
  const double low = std::max(l.low, r.low), high = std::min(l.high, r.high);
  if (!(low < high)) return settle_reversed(left, l.low, right, r.high);
  const bool left_keeps_all = !nearer(right.at(high), left.at(high));
  const bool right_keeps_all = !nearer(left.at(low), right.at(low));
  const bool left_is_inside = r.low < low;
  // As far everywhere, but the right one on the left: the lemma needs one to be nearer.
  if (left_keeps_all && right_keeps_all && left_is_inside && high < l.high) return Order::tangled;
  if (left_keeps_all && !(right_keeps_all && left_is_inside))
    r.low = high;
  else if (right_keeps_all)
    l.high = low;
  else
    l.high = r.low = equal_place(left, right, low, high);
  return Order::cut;
}

void keep_left(const Generator& left, Claim& l, const Generator& gone, const Claim& r) {
  const double low = std::max(l.low, r.low), high = std::min(l.high, r.high);
  if (!(low < high) || !nearer(gone.at(high), left.at(high))) return;
  l.high = nearer(left.at(low), gone.at(low)) ? equal_place(left, gone, low, high) : low;
}

void keep_right(const Generator& gone, const Claim& l, const Generator& right, Claim& r) {
  const double low = std::max(l.low, r.low), high = std::min(l.high, r.high);
  if (!(low < high) || !nearer(gone.at(low), right.at(low))) return;
  r.low = nearer(right.at(high), gone.at(high)) ? equal_place(gone, right, low, high) : high;
}

}  // namespace geodrome::schreiber
