// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/front.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/solver_schreiber/claims.hpp"
#include "plugins/solver_schreiber/lifetime.hpp"

namespace geodrome::schreiber {
namespace {

/// Settles a pair by all their rays. A neighbour that claims nothing of the half-edge any more, because all its rays
/// pass beyond it, may still be what ends another.
PairOrder settle_with_all_rays(const Generator& left, Interval& l, const Generator& right, Interval& r) {
  if ((l.empty() || r.empty()) && l.low >= r.high) return settle_reversed_pair(left, l.low, right, r.high);
  return settle_pair(left, l, right, r);
}

/// Tells whether generator i owns no part of the half-edge between its neighbours.
bool is_dead(const Front& front, std::size_t i, double length) {
  Generator rooms[3];
  const Generator& g = front.look(i, rooms[0]);
  Interval claim = claim_of(g, length);
  if (g.is_sliver() || claim.empty()) return true;
  if (i > 0) {
    const Generator& left = front.look(i - 1, rooms[1]);
    Interval other = claim_of(left, length);
    if (settle_with_all_rays(left, other, g, claim) == PairOrder::drop_right || claim.empty()) return true;
  }
  if (i + 1 < front.size()) {
    const Generator& right = front.look(i + 1, rooms[2]);
    Interval other = claim_of(right, length);
    if (settle_with_all_rays(g, claim, right, other) == PairOrder::drop_left || claim.empty()) return true;
  }
  return false;
}

}  // namespace

void FrontEditor::renew_key(Front& front, std::size_t i) {
  const std::size_t count = front.size();
  if (i >= count) return;
  Generator left, middle, right;
  front.set_key(i, lifetime(i > 0 ? &front.look(i - 1, left) : nullptr, front.look(i, middle),
                            i + 1 < count ? &front.look(i + 1, right) : nullptr));
}

void FrontEditor::renew_seam(Front& front, std::size_t i) {
  const std::size_t count = front.size();
  if (i == 0 || i >= count) return renew_key(front, i == 0 ? 0 : count - 1);
  Generator rooms[4];
  const Generator* before = i > 1 ? &front.look(i - 2, rooms[0]) : nullptr;
  const Generator* behind = i + 1 < count ? &front.look(i + 1, rooms[3]) : nullptr;
  const Generator &left = front.look(i - 1, rooms[1]), &right = front.look(i, rooms[2]);
  const double left_key = lifetime(before, left, &right), right_key = lifetime(&left, right, behind);
  front.set_key(i - 1, left_key);
  front.set_key(i, right_key);
}

void FrontEditor::remove(Front& front, std::size_t i, const Before& before) {
  ++counts_.events;
  const double length = before.length;
  const Generator gone = front[i].moved(before.back);
  const bool was_first = i == 0, was_last = i + 1 == front.size();
  front.erase(i);
  const auto turn_back = [&](double& dx, double& dy) { std::tie(dx, dy) = before.back.turn_back(dx, dy); };
  if (!was_first) {
    Generator left = front[i - 1].moved(before.back);
    Interval l = claim_of(left, length);
    keep_left(left, l, gone, claim_of(gone, length));
    if (was_last) l.high = std::min(l.high, gone.high(length));
    if (left.has_right(l.high, 0)) {
      left.set_high(l.high, 0);
      turn_back(left.high_x, left.high_y);
      set_high(front, i - 1, left);
    }
  }
  if (!was_last) {
    Generator right = front[i].moved(before.back);
    Interval r = claim_of(right, length);
    keep_right(gone, claim_of(gone, length), right, r);
    if (was_first) r.low = std::max(r.low, gone.low(length));
    if (right.has_left(r.low, 0)) {
      right.set_low(r.low, 0);
      turn_back(right.low_x, right.low_y);
      set_low(front, i, right);
    }
  }
  renew_seam(front, i);
}

/// Replaces a ray of generator i by that of `g`, which is in the frame of the front.
void FrontEditor::set_low(Front& front, std::size_t i, const Generator& g) {
  front.update(i, [&](Generator& stored, const Motion& motion) {
    std::tie(stored.low_x, stored.low_y) = motion.turn_back(g.low_x, g.low_y);
  });
}
void FrontEditor::set_high(Front& front, std::size_t i, const Generator& g) {
  front.update(i, [&](Generator& stored, const Motion& motion) {
    std::tie(stored.high_x, stored.high_y) = motion.turn_back(g.high_x, g.high_y);
  });
}

void FrontEditor::aim_low(Front& front, std::size_t i, Generator g, double px, double py) {
  g.set_low(px, py);
  set_low(front, i, g);
}
void FrontEditor::aim_high(Front& front, std::size_t i, Generator g, double px, double py) {
  g.set_high(px, py);
  set_high(front, i, g);
}

/// Computes keys anew because a key may rest on a ray that is cut. (Where only a neighbour's ray is cut, or a neighbour
/// is removed, the old key is not too large.)
void FrontEditor::end_at(Front& front, double px, double py) {
  Generator room;
  const bool all = front.size() <= short_front;
  std::size_t from = front.size();
  for (std::size_t i = front.size(); i-- > 0;) {
    const Generator& g = front.look(i, room);
    if (g.has_right(px, py)) {
      aim_high(front, i, g, px, py);
      from = i;
    } else if (!all) {
      break;
    }
  }
  // A generator that was only as near at the point may have no ray on this side of it; its neighbour's ray is right.
  while (!front.empty() && front.back().is_sliver()) front.erase(front.size() - 1);
  if (!front.empty()) from = std::min(from, front.size() - 1);
  for (std::size_t i = from; i < front.size(); ++i) renew_key(front, i);
}

void FrontEditor::begin_at(Front& front, double px, double py) {
  Generator room;
  const bool all = front.size() <= short_front;
  std::size_t end = 1;
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Generator& g = front.look(i, room);
    if (g.has_left(px, py)) {
      aim_low(front, i, g, px, py);
      end = i + 1;
    } else if (!all) {
      break;
    }
  }
  while (!front.empty() && front.front().is_sliver()) front.erase(0);
  for (std::size_t i = 0; i < std::min(end, front.size()); ++i) renew_key(front, i);
}

Ends FrontEditor::fit(Front& front, double length, const Before& before) {
  Generator room;
  const auto is_outside = [length](const Generator& g) {
    return g.is_sliver() || g.is_on_line_beside(length) || claim_of(g, length).empty();
  };
  while (!front.empty() && is_outside(front.look(front.size() - 1, room))) remove(front, front.size() - 1, before);
  while (!front.empty() && is_outside(front.look(0, room))) remove(front, 0, before);
  if (front.empty()) return {};
  narrow_one(front, 0, length);
  narrow_one(front, front.size() - 1, length);
  return ends_of(front, length);
}

void FrontEditor::narrow(Front& front, double length, double until) {
  for (std::size_t i = 0; (i = front.first_key_at_most(until, i)) < front.size(); ++i)
    for (std::size_t j = i - std::min<std::size_t>(i, 1); j < std::min(front.size(), i + 2); ++j)
      narrow_one(front, j, length);
}

void FrontEditor::narrow_one(Front& front, std::size_t i, double length) {
  Generator room;
  const Generator g = front.look(i, room);
  const bool low = g.passes_low(0), high = g.passes_high(length);
  if (low) aim_low(front, i, g, 0, 0);
  if (high) aim_high(front, i, g, length, 0);
  if (low || high) renew_key(front, i);
}

/// Generators are tested in the order in which they can have died: one that died must not count as a neighbour of
/// others.
bool FrontEditor::bury(Front& front, double length, double until, const Before& before) {
  const std::uint64_t events = counts_.events;
  suspects_.clear();
  const auto suspect = [&](std::size_t i) {
    if (i < front.size() && front[i].key <= until) suspects_.push_back({front[i].key, i});
  };
  for (std::size_t i = 0; (i = front.first_key_at_most(until, i)) < front.size(); ++i) suspect(i);
  while (!suspects_.empty()) {
    const auto next = std::min_element(suspects_.begin(), suspects_.end());
    const std::size_t i = next->second;
    suspects_.erase(next);
    if (!is_dead(front, i, length)) continue;
    remove(front, i, before);
    std::erase_if(suspects_, [i](const auto& other) { return other.second + 1 == i || other.second == i + 1; });
    for (auto& other : suspects_) other.second -= other.second > i;
    if (i > 0) suspect(i - 1);
    suspect(i);
  }
  return counts_.events > events;
}

void FrontEditor::join(Front& left, Front right, double length) {
  while (!left.empty() && !right.empty()) {
    const std::size_t end = left.size() - 1;
    Generator a = left[end], b = right[0];
    Interval l = claim_of(a, length), r = claim_of(b, length);
    const PairOrder order = settle_pair(a, l, b, r);
    if (order == PairOrder::tangled) return merge(left, std::move(right), length);
    const bool cut = order == PairOrder::cut;
    if (cut) a.set_high(l.high, 0), b.set_low(r.low, 0);
    if (order == PairOrder::drop_left || l.empty() || a.is_sliver() ||
        (cut && end > 0 && !right_has(left[end - 1], a, l.high, 0))) {
      remove(left, end, {{}, length});
    } else if (order == PairOrder::drop_right || r.empty() || b.is_sliver() ||
               (cut && right.size() > 1 && right_has(b, right[1], r.low, 0))) {
      remove(right, 0, {{}, length});
    } else {
      if (cut) set_high(left, end, a), set_low(right, 0, b);
      break;
    }
  }
  if (right.empty()) return;
  if (left.empty()) return left.swap(right);
  const std::size_t seam = left.size();
  left.append(std::move(right));
  ++counts_.joins;
  renew_seam(left, seam);
}

Front FrontEditor::trimmed(const Front& front, double length) { return front_of(pieces_of(front, length)); }

Front FrontEditor::front_of(const Pieces& pieces) {
  std::vector<Generator> generators;
  generators.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    Generator g = piece.generator;
    g.set_low(piece.low, 0), g.set_high(piece.high, 0);
    if (!g.is_sliver()) generators.push_back(g);
  }
  return front_of(std::move(generators));
}

Front FrontEditor::front_of(std::vector<Generator> generators) {
  for (std::size_t i = 0; i < generators.size(); ++i)
    generators[i].key = lifetime(i > 0 ? &generators[i - 1] : nullptr, generators[i],
                                 i + 1 < generators.size() ? &generators[i + 1] : nullptr);
  return Front(pool_, std::span<const Generator>(generators));
}

void FrontEditor::merge(Front& front, Front other, double length) {
  if (other.empty()) return;
  if (front.empty()) return front.swap(other);
  ++counts_.envelopes;
  front = front_of(nearest_pieces(pieces_of(front, length), pieces_of(other, length)));
}

Front FrontEditor::mirrored(const Front& front, double length) {
  std::vector<Generator> reversed;
  front.for_each([&](const Generator& g) { reversed.push_back(g.mirrored(length)); });
  std::reverse(reversed.begin(), reversed.end());
  return Front(pool_, std::span<const Generator>(reversed));
}

}  // namespace geodrome::schreiber
