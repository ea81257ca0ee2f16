// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plugins/solver_schreiber/generator.hpp"
#include "plugins/solver_schreiber/sequence.hpp"

namespace geodrome::schreiber {

/// A generator and a piece of a half-edge on which it is the nearest.
struct Piece {
  Generator generator;
  double low, high;
};
using Pieces = std::vector<Piece>;

/// Divides a half-edge among the generators of a front, each cut against its neighbours; the pieces ascend. Runs of
/// generators that are in no order with each other are separated by a lower envelope. O(n).
Pieces pieces_of(const Sequence<Generator>& front, double length);

/// Returns the lower envelope of two lists of ascending pieces: at every place the nearer generator. O(n + m).
Pieces nearest_pieces(const Pieces& a, const Pieces& b);

}  // namespace geodrome::schreiber
