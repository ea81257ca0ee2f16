// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"

namespace geodrome {

/// An image with a piece of an edge that its rays cross, in the frame of a half-edge on that edge.
struct EdgePiece {
  double x, y, sigma, low, high;
  std::uint32_t number;  ///< the caller's own

  double at(double place) const { return sigma + std::sqrt((place - x) * (place - x) + y * y); }
};
using EdgePieces = std::vector<EdgePiece>;

/// The nearest images that came to each edge of more than two faces (a fan) so far, place by place, whichever face they
/// came from. Without it wavefronts multiply: each face of a fan sends on into all others, and what left through
/// several of them meets again on the next edges, where nothing tells that one of two ways is enough. This lemma does:
///
///   Let a ray of image N and a ray of image W come to place x of an edge. If W is not farther at x than N, then the
///   ray of N is not needed beyond x, in any face.
///
/// Proof: let the ray of N go on to p in face C. The way of W to x, then straight to p, is not longer. It may bend at
/// x, as it does if W came from C: then a shorter way exists, and the ray of N is not shortest at p. Otherwise it is
/// the ray of W itself, which goes on into C.
///
/// One per thread.
class FanEnvelope {
 public:
  explicit FanEnvelope(const PackedMesh& surface) : surface_(surface) {}

  /// Forgets everything. O(edges touched).
  void reset();

  /// Takes disjoint ascending pieces that came to a fan through half-edge `edge`, in the frame of one that runs against
  /// it. Leaves the parts of them that are nearer, by more than rounding, than what came before, and remembers those. A
  /// piece that comes alone and whose image is close to the edge is left whole, or not at all. O(n + pieces of the
  /// edge).
  void claim(Index edge, EdgePieces& pieces);

  /// Leaves the parts of disjoint ascending pieces, in the frame of `half_edge`, to which nothing came by now that is
  /// nearer by more than rounding. O(n + pieces of the edge).
  void keep_nearest(Index half_edge, EdgePieces& pieces);

  std::size_t bytes() const;

 private:
  const PackedMesh& surface_;
  std::vector<EdgePieces> nearest_;  ///< of each fan, in the frame that begins at the vertex with the lower number
  std::vector<Index> touched_;
  EdgePieces given_, parts_, all_;  ///< scratch
};

}  // namespace geodrome
