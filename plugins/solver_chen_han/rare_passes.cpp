// SPDX-License-Identifier: MIT
// What a propagation does where rounding has put the windows of a pass out of order, or made some of them useless.
#include <cmath>

#include "plugins/common/exact/least_distance.hpp"
#include "plugins/solver_chen_han/propagation.hpp"

namespace geodrome::chen_han {

/// Windows whose lines cross beyond the half-edge, so that they do not lie to the left and right of the apex in order.
void Propagation::carry_one_by_one(const Apex& apex, const Span& list, Index depth) {
  const WindowArrays& w = list.windows;
  sides_.clear();
  std::size_t best = list.count;
  for (std::size_t i = 0; i < list.count; ++i) {
    const Sides sides{has_left(apex, w, i), has_right(apex, w, i), w.to(i, apex.x, apex.y)};
    const double x = sides.both() ? w.x()[i] : sides.left ? w.high()[i] : w.low()[i];
    const double way = way_through(w.get(i), apex.x, apex.y, labels_.distance(apex.vertex()));
    if (may_lower(apex, list, i, way)) lower_apex_by(apex, list, i, sides.both() ? x : bend_at(w, i, x), way);
    if (sides.both() && (best == list.count || sides.way < sides_[best].way)) best = i;
    sides_.push_back(sides);
  }
  const double equally_near = best < list.count ? sides_[best].way * (1 + equal_share) : 0;
  chosen_left_.clear(), chosen_right_.clear();
  for (std::size_t i = 0; i < list.count; ++i) {
    const bool to_both = !sides_[i].both() || sides_[i].way <= equally_near;
    if (sides_[i].left && (to_both || i <= best)) chosen_left_.push(w.get(i));
    if (sides_[i].right && (to_both || i >= best)) chosen_right_.push(w.get(i));
  }
  const Span left = chosen_left_.span(), right = chosen_right_.span();
  carry(apex, to_left(left, left.count), to_right(right, 0), depth);
}

/// Lowers the apex by paths that bend at the ends of windows on the other side of windows that are all rounding: of the
/// first `before` windows, and from window `after` on.
[[gnu::cold]] void Propagation::lower_apex_over(const Apex& apex, const Span& list, std::size_t before,
                                                std::size_t after) {
  const WindowArrays& w = list.windows;
  const double close = close_share * apex.length;
  const auto bent = [&](std::size_t i, double place) {
    const double way = w.at(i, place) + std::hypot(place - apex.x, apex.y);
    if (may_lower(apex, list, i, way)) lower_apex_by(apex, list, i, bend_at(w, i, place), way);
  };
  for (std::size_t i = before; i > 1 && w.high()[before - 1] - w.low()[i - 1] <= close; --i)
    bent(i - 2, w.high()[i - 2]);
  for (std::size_t i = after; i + 1 < list.count && w.high()[i] - w.low()[after] <= close; ++i)
    bent(i + 1, w.low()[i + 1]);
}

}  // namespace geodrome::chen_han
