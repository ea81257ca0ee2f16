// SPDX-License-Identifier: MIT
#include "plugins/common/exact/fan_envelope.hpp"

#include <algorithm>

#include "plugins/common/exact/close_image.hpp"
#include "plugins/common/exact/lower_envelope.hpp"

namespace geodrome {
namespace {

/// Adapts pieces to lower_envelope.hpp.
struct EdgeRow {
  const EdgePieces& pieces;

  std::size_t size() const { return pieces.size(); }
  double low(std::size_t i) const { return pieces[i].low; }
  double high(std::size_t i) const { return pieces[i].high; }
  const EdgePiece& image(std::size_t i) const { return pieces[i]; }
};

EdgePiece with_ends(EdgePiece piece, double low, double high) {
  piece.low = low, piece.high = high;
  return piece;
}

/// Replaces `pieces` by the same as seen from a half-edge of `length` that runs the other way.
void mirror(EdgePieces& pieces, double length) {
  for (EdgePiece& p : pieces) p = {length - p.x, p.y, p.sigma, length - p.high, length - p.low, p.number};
  std::reverse(pieces.begin(), pieces.end());
}

/// Replaces `parts` of mirrored pieces by the parts of the pieces themselves, without rounding where a part ends with
/// its piece.
void mirror_back(EdgePieces& parts, const EdgePieces& mirrored, const EdgePieces& pieces, double length) {
  std::size_t of = 0;
  for (EdgePiece& part : parts) {
    while (mirrored[of].number != part.number) ++of;
    const EdgePiece& whole = pieces[pieces.size() - 1 - of];
    part = with_ends(whole, part.high == mirrored[of].high ? whole.low : length - part.high,
                     part.low == mirrored[of].low ? whole.high : length - part.low);
  }
  std::reverse(parts.begin(), parts.end());
}

}  // namespace
void FanEnvelope::reset() {
  for (const Index fan : touched_) nearest_[fan].clear();
  touched_.clear();
}

void FanEnvelope::claim(Index edge, EdgePieces& pieces) {
  nearest_.resize(surface_.fan_count());
  EdgePieces& nearest = nearest_[surface_.fan(edge)];
  if (nearest.empty()) touched_.push_back(surface_.fan(edge));
  const double length = surface_.length(edge);
  const bool turned = surface_.from(edge) < surface_.from(SurfaceMesh::next(edge));
  given_ = pieces;
  if (turned) mirror(given_, length);
  parts_.clear(), all_.clear();
  const auto take = [&](const EdgeRow& row, std::size_t i, double low, double high) {
    all_.push_back(with_ends(row.image(i), low, high));
    if (&row.pieces == &given_) parts_.push_back(all_.back());
  };
  lower_envelope(EdgeRow{nearest}, EdgeRow{given_}, take, {.share = equal_share});
  nearest.swap(all_);
  if (given_.size() == 1 && !parts_.empty() && is_close(given_[0], {given_[0].low, given_[0].high}, length)) return;
  if (turned) mirror_back(parts_, given_, pieces, length);
  pieces.swap(parts_);
}

void FanEnvelope::keep_nearest(Index half_edge, EdgePieces& pieces) {
  const EdgePieces& nearest = nearest_[surface_.fan(half_edge)];
  const double length = surface_.length(half_edge);
  const bool turned = surface_.from(half_edge) > surface_.from(SurfaceMesh::next(half_edge));
  given_ = pieces;
  if (turned) mirror(given_, length);
  parts_.clear();
  const auto take = [&](const EdgeRow& row, std::size_t i, double low, double high) {
    if (&row.pieces == &given_) parts_.push_back(with_ends(row.image(i), low, high));
  };
  // Mirrored to and fro, the place of an image moves by rounding of the edge's length; what is in the envelope itself
  // must not count as beaten by it.
  lower_envelope(EdgeRow{given_}, EdgeRow{nearest}, take, {.share = rounding_share, .span = length});
  if (turned) mirror_back(parts_, given_, pieces, length);
  pieces.swap(parts_);
}

std::size_t FanEnvelope::bytes() const {
  std::size_t sum = nearest_.capacity() * sizeof(EdgePieces) + touched_.capacity() * sizeof(Index);
  for (const Index fan : touched_) sum += nearest_[fan].capacity() * sizeof(EdgePiece);
  return sum + (given_.capacity() + parts_.capacity() + all_.capacity()) * sizeof(EdgePiece);
}

}  // namespace geodrome
