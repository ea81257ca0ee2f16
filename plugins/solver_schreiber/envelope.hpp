// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "plugins/solver_schreiber/generator.hpp"
#include "plugins/solver_schreiber/sequence.hpp"

namespace geodrome::schreiber {

/// A generator and a part of a half-edge that it has.
struct Piece {
  Generator generator;
  double low, high;
  std::size_t name;  ///< the same for all parts of one generator
};
using Pieces = std::vector<Piece>;

/// What the generators of a front have of a half-edge, from its start to its end, each cut against its neighbours;
/// named from `first_name` on. Runs that are in no order are cut against each other point by point. O(n).
Pieces pieces_of(const Sequence<Generator>& front, double length, std::size_t first_name);

/// Two lists of pieces in order, with different names: the nearest everywhere. O(n + m).
Pieces lower_envelope(const Pieces& a, const Pieces& b);

}  // namespace geodrome::schreiber
