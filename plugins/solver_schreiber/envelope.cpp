// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/envelope.hpp"

#include <algorithm>

#include "plugins/common/exact/lower_envelope.hpp"
#include "plugins/solver_schreiber/claims.hpp"

namespace geodrome::schreiber {
namespace {

/// Adapts pieces to lower_envelope.hpp.
struct PieceRow {
  const Pieces& pieces;

  std::size_t size() const { return pieces.size(); }
  double low(std::size_t i) const { return pieces[i].low; }
  double high(std::size_t i) const { return pieces[i].high; }
  const Generator& image(std::size_t i) const { return pieces[i].generator; }
};

}  // namespace

Pieces nearest_pieces(const Pieces& a, const Pieces& b) {
  Pieces result;
  lower_envelope(PieceRow{a}, PieceRow{b}, [&](const PieceRow& row, std::size_t i, double low, double high) {
    result.push_back({row.image(i), low, high});
  });
  return result;
}

Pieces pieces_of(const Sequence<Generator>& front, double length) {
  Pieces result, in_order;
  front.for_each([&](const Generator& g) {
    Interval claim = claim_of(g, length);
    while (!in_order.empty()) {
      Piece& last = in_order.back();
      Interval before{last.low, last.high};
      const PairOrder order = settle_pair(last.generator, before, g, claim);
      if (order == PairOrder::drop_right || claim.empty()) return;
      if (order == PairOrder::tangled) {
        result = nearest_pieces(result, in_order);
        in_order.clear();
        break;
      }
      last.high = before.high;
      if (order != PairOrder::drop_left && !before.empty()) break;
      in_order.pop_back();
    }
    if (!claim.empty()) in_order.push_back({g, claim.low, claim.high});
  });
  return nearest_pieces(result, in_order);
}

}  // namespace geodrome::schreiber
