// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/envelope.hpp"

#include <algorithm>
#include <limits>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/solver_schreiber/claims.hpp"

namespace geodrome::schreiber {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The lower envelope as it grows from left to right; pieces of one generator that touch are one.
class Envelope {
 public:
  Pieces pieces;

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

}  // namespace

Pieces lower_envelope(const Pieces& a, const Pieces& b) {
  Envelope envelope;
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

Pieces pieces_of(const Sequence<Generator>& front, double length, std::size_t first_name) {
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
        result = lower_envelope(result, in_order);
        in_order.clear();
        break;
      }
      last.high = before.high;
      if (order != Order::drop_left && !before.empty()) break;
      in_order.pop_back();
    }
    if (!claim.empty()) in_order.push_back({g, claim.low, claim.high, name});
  });
  return lower_envelope(result, in_order);
}

}  // namespace geodrome::schreiber
