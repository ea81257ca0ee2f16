// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_aleksandrov/intrinsic/triangulation.hpp"

namespace geodrome::aleksandrov {

/// Cosine and sine of half the angle at a corner of a face, exact for thin angles too.
struct HalfAngle {
  double cosine, sine;
};
HalfAngle half_angle(const IntrinsicTriangulation::Face& face, int corner);

enum class Placement {
  thin,      ///< ours, see PROOF.md
  published  ///< Aleksandrov, Maheshwari and Sack 2005
};

/// Where Steiner points go on the bisector of a face angle: the first `first` from the vertex, each of the others
/// `ratio` times as far as the one before it.
struct Bisector {
  double first = 0, ratio = 1;
  double count = 0;  ///< a whole number, however large
};

/// Puts Steiner points on bisectors such that distances are at most 1 + delta times too long (PROOF.md has the proof).
class SteinerPlacement {
 public:
  /// `delta` in (0, 1]. `thinning` >= 1 makes steps so many times as long, and voids the guarantee above 1.
  SteinerPlacement(const IntrinsicTriangulation& triangulation, Placement placement, double delta, double thinning);

  /// At corner h % 3 of face h / 3. No points where a leg of the angle is on the boundary: no shortest path crosses it
  /// to go on.
  Bisector at(Index h) const;

 private:
  const IntrinsicTriangulation& t_;
  Placement placement_;
  std::vector<double> radius_;  ///< of the vicinity of each vertex, in which paths lead through the vertex
  double step_ = 0;             ///< thin: the step over the tangent of half the angle; published: over its sine
};

/// How many nodes the graph has that comes of a placement: what it and a search take of memory. O(F).
double node_count(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement);

/// About how many edges the graph has that comes of a placement, counted from both ends: what a search costs. O(F).
double edge_count(const IntrinsicTriangulation& triangulation, const SteinerPlacement& placement);

}  // namespace geodrome::aleksandrov
