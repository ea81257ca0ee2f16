// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// The half-plane n.x <= offset with unit normal n, cut out by the bisector of the cell's site and another; `site` is
/// no_index for an edge that is no bisector.
struct HalfPlane {
  double nx = 0, ny = 0, offset = 0;
  Index site = no_index;
};

/// A corner of a cell, and the edge that leaves it counter-clockwise.
struct CellCorner {
  double x = 0, y = 0;
  HalfPlane edge;
};

/// The planar Voronoi cell of a site at the origin, while it is cut by half-planes: a convex polygon that contains the
/// origin.
///
/// The cell starts as the square of half-side 2 `reach`; the edges of the square stand for infinity. A corner is real
/// if both its edges are bisectors and it is not farther than `reach`; any other means that the cell has no end.
/// Corners are computed from their two edges, not from earlier corners, so errors do not add up.
class PlanarCell {
 public:
  /// Starts a new cell. `reach` > 0.
  void reset(double reach);

  /// Cuts off everything outside `half_plane`; returns false if there was nothing. Precondition: its offset is
  /// positive. O(corners).
  bool cut(const HalfPlane& half_plane);

  const std::vector<CellCorner>& corners() const noexcept { return corners_; }

  /// Returns the distance of the farthest corner, real or not: a site farther than twice this cuts nothing.
  double farthest() const noexcept { return farthest_; }

  /// Tells whether both edges of the corner are bisectors, and it is within reach.
  bool real(std::size_t corner) const;

  /// Tells whether every corner is real.
  bool bounded() const;

  /// Returns the distance of the farthest real corner, if there is one.
  std::optional<double> farthest_real() const;

  /// Returns the distance of the farthest line that bears a real edge, if there is one.
  std::optional<double> farthest_edge() const;

 private:
  void measure();

  double reach_ = 0, farthest_ = 0;
  std::vector<CellCorner> corners_, scratch_;
  std::vector<double> excess_;
};

}  // namespace geodrome
