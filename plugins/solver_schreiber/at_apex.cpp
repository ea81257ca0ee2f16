// SPDX-License-Identifier: MIT
// The members of Propagation for the meeting of a front with the apex of a face.
#include <algorithm>
#include <cmath>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/solver_schreiber/claimant.hpp"
#include "plugins/solver_schreiber/propagation.hpp"

namespace geodrome::schreiber {

/// Splits a front at the apex. The owner of the apex, and generators as near up to rounding, go on to both sides, all
/// others to their own side: one angle, one split. A generator with rays to the wrong side only has died before the
/// apex and is removed if it is not nearer there (the lemma of ordered neighbours, with the apex for x); otherwise the
/// front is out of order.
Propagation::Split Propagation::split_at(const Apex& apex, Front& front, double until) {
  const double x = apex.x, y = apex.y;
  const std::size_t best = owner_of(front, x, y, until);
  const Generator owner = front[best];
  Split split = around(owner, best, front, apex);
  Generator room;
  for (std::size_t i = 0; (i = front.first_key_at_most(until, i)) < front.size();) {
    const Generator& g = front.look(i, room);
    const bool is_left = i < split.right_begin, is_right = i >= split.left_end;
    if (!(is_left && !g.has_left(x, y)) && !(is_right && !g.has_right(x, y))) {
      ++i;
      continue;
    }
    split.in_order = split.in_order && split.covered && !nearer(g.to(x, y), owner.to(x, y));
    if (!split.in_order) break;
    editor_.remove(front, i, {{}, apex.length});
    if (is_left) --split.right_begin, --split.left_end;
  }
  return split;
}

/// Returns the split at generator `best`, which is `g`. Generator `best` owns the apex if it has a ray to it.
Propagation::Split Propagation::around(const Generator& g, std::size_t best, const Front& front, const Apex& apex) {
  const double x = apex.x, y = apex.y;
  if (!g.reaches(x, y)) {
    const std::size_t after = g.inside_high(x, y) ? best : best + 1;
    return {after, after, false, true};
  }
  const double most = g.to(x, y) * (1 + equal_share);
  const auto is_as_near = [&](const Generator& other) { return other.reaches(x, y) && other.to(x, y) <= most; };
  Split split{best + 1, best, true, true};
  while (split.right_begin > 0 && is_as_near(front[split.right_begin - 1])) --split.right_begin;
  while (split.left_end < front.size() && is_as_near(front[split.left_end])) ++split.left_end;
  return split;
}

/// Lowers the distance of the apex: by its owner, by the outermost rays of the neighbours, and along the edges. A path
/// that bends at the end of what a generator claims of the half-edge exists as well; it serves a vertex in the gap
/// between two generators that rounding, or a saddle too flat to count as one, has made.
void Propagation::lower_apex(const Apex& apex, const Front& front, const Split& split) {
  std::size_t before = split.left_end, after = split.right_begin;
  if (split.covered) {
    for (std::size_t i = split.right_begin; i < split.left_end; ++i) {
      const Generator g = front[i];
      lower_apex_by(apex, g, g.x, g.to(apex.x, apex.y));
    }
    before = split.right_begin, after = split.left_end;
  }
  if (before > 0) lower_apex_bent(apex, front[before - 1]);
  if (after < front.size()) lower_apex_bent(apex, front[after]);
  lower_along_edges(apex);
}

void Propagation::lower_apex_bent(const Apex& apex, const Generator& g) {
  if (g.covers(apex.x, apex.y)) return;
  const double x = g.inside_high(apex.x, apex.y) ? g.low(apex.length) : g.high(apex.length);
  lower_apex_by(apex, g, x, g.at(x) + std::sqrt((apex.x - x) * (apex.x - x) + apex.y * apex.y));
}

/// Lowers the distance of the apex by a generator: straight from its image, or bent at (x, 0).
void Propagation::lower_apex_by(const Apex& apex, const Generator& g, double x, double distance) {
  lower_apex_from(apex, {g.x, g.y, g.sigma, g.origin}, x, distance, [&] {
    const double climb = apex.y - g.y;
    const double straight = climb > 0 ? g.x + (apex.x - g.x) * (-g.y / climb) : apex.x;
    const double crossing = x != g.x ? x : std::clamp(straight, 0.0, apex.length);
    return Step{crossing, apex.half_edge, no_index, kept_.last(), g.origin};
  });
}

}  // namespace geodrome::schreiber
