// SPDX-License-Identifier: MIT
#include "solver_schreiber/front.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/solvers/bisector.hpp"
#include "solver_schreiber/claims.hpp"

namespace geodrome::schreiber {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether generator i has nothing of the half-edge between its neighbours.
bool is_dead(const Front& front, std::size_t i, double length) {
  Generator rooms[3];
  const Generator& g = front.look(i, rooms[0]);
  Claim claim = claim_of(g, length);
  if (g.is_sliver() || claim.empty()) return true;
  if (i > 0) {
    const Generator& left = front.look(i - 1, rooms[1]);
    Claim other = claim_of(left, length);
    if (settle(left, other, g, claim) == Order::drop_right || claim.empty()) return true;
  }
  if (i + 1 < front.size()) {
    const Generator& right = front.look(i + 1, rooms[2]);
    Claim other = claim_of(right, length);
    if (settle(g, claim, right, other) == Order::drop_left || claim.empty()) return true;
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

void FrontEditor::remove(Front& front, std::size_t i, const Before& before) {
  ++counts_.events;
  const double length = before.length;
  const Generator gone = front[i].moved(before.back);
  const bool was_first = i == 0, was_last = i + 1 == front.size();
  front.erase(i);
  const auto turn_back = [&](double& dx, double& dy) { std::tie(dx, dy) = before.back.turn_back(dx, dy); };
  if (!was_first) {
    Generator left = front[i - 1].moved(before.back);
    Claim l = claim_of(left, length);
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
    Claim r = claim_of(right, length);
    keep_right(gone, claim_of(gone, length), right, r);
    if (was_first) r.low = std::max(r.low, gone.low(length));
    if (right.has_left(r.low, 0)) {
      right.set_low(r.low, 0);
      turn_back(right.low_x, right.low_y);
      set_low(front, i, right);
    }
  }
  if (!was_first) renew_key(front, i - 1);
  renew_key(front, i);
}

/// The ray of `g`, in the frame of the front, becomes that of generator i.
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

void FrontEditor::fit(Front& front, double length, const Before& before) {
  Generator room;
  const auto is_outside = [length](const Generator& g) { return g.is_sliver() || claim_of(g, length).empty(); };
  while (!front.empty() && is_outside(front.look(front.size() - 1, room))) remove(front, front.size() - 1, before);
  while (!front.empty() && is_outside(front.look(0, room))) remove(front, 0, before);
  if (front.empty()) return;
  const Generator& first = front.look(0, room);
  if (first.passes_low(0)) {
    aim_low(front, 0, first, 0, 0);
    renew_key(front, 0);
  }
  const std::size_t end = front.size() - 1;
  const Generator& last = front.look(end, room);
  if (last.passes_high(length)) {
    aim_high(front, end, last, length, 0);
    renew_key(front, end);
  }
}

/// In the order in which they can have died: one that died must not be taken for a neighbour of others.
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
    Claim l = claim_of(a, length), r = claim_of(b, length);
    const Order order = settle(a, l, b, r);
    if (order == Order::tangled) return merge(left, std::move(right), length);
    const bool cut = order == Order::cut;
    if (cut) a.set_high(l.high, 0), b.set_low(r.low, 0);
    if (order == Order::drop_left || l.empty() || a.is_sliver() ||
        (cut && end > 0 && !right_has(left[end - 1], a, l.high, 0))) {
      remove(left, end, {{}, length});
    } else if (order == Order::drop_right || r.empty() || b.is_sliver() ||
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
  renew_key(left, seam - 1);
  renew_key(left, seam);
}

namespace {

/// The lower envelope as it grows from left to right; pieces of one generator that touch are one.
template <class Piece>
class Envelope {
 public:
  std::vector<Piece> pieces;

  void add(const Piece& piece, double low, double high) {
    if (!(low < high)) return;
    if (!pieces.empty() && pieces.back().name == piece.name && pieces.back().high == low) {
      pieces.back().high = high;
      return;
    }
    pieces.push_back(piece);
    pieces.back().low = low, pieces.back().high = high;
  }

  /// The nearer of two, everywhere in [low, high]. |a x| - |b x| has one stationary point along a line, where that of
  /// the images meets it; before and behind it the two change places at most once.
  void add_nearer(const Piece& a, const Piece& b, double low, double high) {
    const Generator &g = a.generator, &h = b.generator;
    const double turn = h.x + (g.x - h.x) * (h.y / (h.y - g.y));
    if (low < turn && turn < high) {
      add_monotone(a, b, low, turn);
      low = turn;
    }
    add_monotone(a, b, low, high);
  }

 private:
  void add_monotone(const Piece& a, const Piece& b, double low, double high) {
    const double at_low = a.generator.at(low) - b.generator.at(low);
    const double at_high = a.generator.at(high) - b.generator.at(high);
    const bool a_first = at_low < 0 || (at_low == 0 && at_high <= 0);
    const bool a_last = at_high < 0 || (at_high == 0 && at_low <= 0);
    const double x = a_first == a_last ? high : equal_place(a.generator, b.generator, low, high);
    add(a_first ? a : b, low, x);
    add(a_last ? a : b, x, high);
  }
};

/// Two lists of pieces in order cut against each other.
template <class Piece>
std::vector<Piece> nearest(const std::vector<Piece>& a, const std::vector<Piece>& b) {
  Envelope<Piece> envelope;
  double x = -infinity;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const double low_a = i < a.size() ? std::max(a[i].low, x) : infinity;
    const double low_b = j < b.size() ? std::max(b[j].low, x) : infinity;
    const double high_a = i < a.size() ? a[i].high : infinity, high_b = j < b.size() ? b[j].high : infinity;
    if (i < a.size() && !(low_a < high_a)) {
      ++i;
    } else if (j < b.size() && !(low_b < high_b)) {
      ++j;
    } else if (low_a < low_b) {
      x = std::min(high_a, low_b);
      envelope.add(a[i], low_a, x);
    } else if (low_b < low_a) {
      x = std::min(high_b, low_a);
      envelope.add(b[j], low_b, x);
    } else {
      x = std::min(high_a, high_b);
      envelope.add_nearer(a[i], b[j], low_a, x);
    }
  }
  return envelope.pieces;
}

}  // namespace

Front FrontEditor::trimmed(const Front& front, double length) { return front_of(pieces(front, length, 0)); }

FrontEditor::Pieces FrontEditor::pieces(const Front& front, double length, std::size_t first_name) const {
  Pieces result, in_order;
  front.for_each([&](const Generator& g) {
    Claim claim = claim_of(g, length);
    const std::size_t name = first_name++;
    while (!in_order.empty()) {
      Piece& last = in_order.back();
      Claim before{last.low, last.high};
      const Order order = settle(last.generator, before, g, claim);
      if (order == Order::drop_right || claim.empty()) return;
      if (order == Order::tangled) {
        result = nearest(result, in_order);
        in_order.clear();
        break;
      }
      last.high = before.high;
      if (order != Order::drop_left && !before.empty()) break;
      in_order.pop_back();
    }
    if (!claim.empty()) in_order.push_back({g, claim.low, claim.high, name});
  });
  return nearest(result, in_order);
}

Front FrontEditor::front_of(const std::vector<Piece>& pieces) {
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
  front = front_of(nearest(pieces(front, length, 0), pieces(other, length, front.size())));
}

Front FrontEditor::mirrored(const Front& front, double length) {
  std::vector<Generator> reversed;
  front.for_each([&](const Generator& g) { reversed.push_back(g.mirrored(length)); });
  std::reverse(reversed.begin(), reversed.end());
  return Front(pool_, std::span<const Generator>(reversed));
}

}  // namespace geodrome::schreiber
