// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_schreiber/generator.hpp"

namespace geodrome::schreiber {

/// What a generator has of a half-edge.
struct Claim {
  double low, high;
  bool empty() const { return !(low < high); }
};
inline Claim claim_of(const Generator& g, double length) { return {g.low(length), g.high(length)}; }

/// What becomes of a pair in order.
enum class Order { apart, cut, drop_left, drop_right, tangled };

/// Cuts the claims of neighbours in order against each other, with nothing else known. Where the two are equally far up
/// to rounding, as along the line from one through the other, no claim is cut for the sake of one inside it: what
/// rounding would then take from it nothing else would cover.
Order settle(const Generator& left, Claim& l, const Generator& right, Claim& r);

/// All that the left one has, from `left_low` on, lies on the right of all that the right one has, up to `right_high`:
/// all their rays cross before the half-edge.
Order settle_reversed(const Generator& left, double left_low, const Generator& right, double right_high);

/// What the neighbour of one that is gone had of a half-edge beside it: all where it was as near up to rounding.
void keep_left(const Generator& left, Claim& l, const Generator& gone, const Claim& r);
void keep_right(const Generator& gone, const Claim& l, const Generator& right, Claim& r);

}  // namespace geodrome::schreiber
