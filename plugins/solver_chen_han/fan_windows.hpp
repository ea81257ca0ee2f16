// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "plugins/common/exact/fan_envelope.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// Cuts windows at edges of more than two faces against all that came there from any face (FanEnvelope).
class FanWindows {
 public:
  explicit FanWindows(const PackedMesh& surface) : envelope_(surface) {}
  void reset() { envelope_.reset(); }

  /// Returns the parts of windows, disjoint and ascending in the frame of a half-edge against `edge`, that are nearer
  /// than what came before; they count as having come. Valid until the next call.
  const WindowList& claim(Index edge, const WindowArrays& windows, std::size_t count);

  /// Drops the parts of waiting windows of `half_edge` that something nearer has come to since.
  void keep_nearest(Index half_edge, WindowList& list);

  std::size_t bytes() const { return envelope_.bytes() + pieces_.capacity() * sizeof(EdgePiece) + parts_.bytes(); }

 private:
  void list_pieces(const WindowArrays& windows, std::size_t count);
  void list_parts(const WindowArrays& windows);

  FanEnvelope envelope_;
  EdgePieces pieces_;
  WindowList parts_;
};

}  // namespace geodrome::chen_han
