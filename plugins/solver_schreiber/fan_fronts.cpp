// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/fan_fronts.hpp"

namespace geodrome::schreiber {

void FanFronts::claim(Front& front, Index edge) {
  const Pieces given = list_pieces(front, surface_.length(edge));
  envelope_.claim(edge, pieces_);
  leave_parts(front, given);
}

void FanFronts::keep_nearest(Front& front, Index half_edge) {
  const Pieces given = list_pieces(front, surface_.length(half_edge));
  envelope_.keep_nearest(half_edge, pieces_);
  leave_parts(front, given);
}

/// Returns what each generator owns of the half-edge, and lists it in `pieces_`.
Pieces FanFronts::list_pieces(const Front& front, double length) {
  const Pieces given = pieces_of(front, length);
  pieces_.clear();
  for (const auto& [g, low, high] : given)
    pieces_.push_back({g.x, g.y, g.sigma, low, high, static_cast<std::uint32_t>(pieces_.size())});
  return given;
}

/// Leaves the front as it is, with all its rays, if nothing was cut.
void FanFronts::leave_parts(Front& front, const Pieces& given) {
  bool as_given = pieces_.size() == given.size();
  Pieces parts;
  for (const EdgePiece& piece : pieces_) {
    const Piece& whole = given[piece.number];
    as_given = as_given && piece.low == whole.low && piece.high == whole.high;
    parts.push_back({whole.generator, piece.low, piece.high});
  }
  if (!as_given) front = editor_.front_of(parts);
}

}  // namespace geodrome::schreiber
