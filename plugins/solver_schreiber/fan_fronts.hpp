// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "plugins/common/exact/fan_envelope.hpp"
#include "plugins/solver_schreiber/front.hpp"

namespace geodrome::schreiber {

/// Cuts fronts at edges of more than two faces against all that came there from any face (FanEnvelope).
class FanFronts {
 public:
  FanFronts(const PackedMesh& surface, FrontEditor& editor) : surface_(surface), editor_(editor), envelope_(surface) {}
  void reset() { envelope_.reset(); }

  /// Leaves of a front, in the frame of a half-edge against `edge`, what is nearer than what came there before; that
  /// counts as having come. O(n + pieces of the edge).
  void claim(Front& front, Index edge);

  /// Drops the parts of a waiting front of `half_edge` that something nearer has come to since.
  void keep_nearest(Front& front, Index half_edge);

  std::size_t bytes() const { return envelope_.bytes() + pieces_.capacity() * sizeof(EdgePiece); }

 private:
  Pieces list_pieces(const Front& front, double length);
  void leave_parts(Front& front, const Pieces& given);

  const PackedMesh& surface_;
  FrontEditor& editor_;
  FanEnvelope envelope_;
  EdgePieces pieces_;
};

}  // namespace geodrome::schreiber
