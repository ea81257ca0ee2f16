// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "plugins/common/points/neighbours.hpp"
#include "plugins/common/points/planar_cell.hpp"

namespace geodrome {

/// The value phi of one point, with a flag for a planar cell that has an end.
struct CellRadius {
  double phi = 0;
  bool bounded = false;
};

/// Returns twice the largest distance from the centroid: no two points are farther apart, and a cell that goes farther
/// than the sample does has no end. Unlike the bounding box it turns with the sample. At least one point. O(n).
double sample_reach(std::span<const Vec3> points);

/// Computes phi(s) of Theorem 3: the distance of s from the farthest vertex of the planar Voronoi cell of s, which is
/// the cell of s in space cut by the tangent plane through s. Exact up to rounding: no neighbour that matters is
/// missed.
///
/// phi of a cell without an end (with a corner farther than `reach`, or with none on some side) is the distance of the
/// farthest real vertex, or of the farthest edge if there is no such vertex: both are distances that the cell certainly
/// reaches. Keeps buffers: one object per thread.
class CellRadiusFinder {
 public:
  /// Sets how far a cell may go before it counts as one without an end: `reach`. `neighbours` must outlive this object.
  CellRadiusFinder(const Neighbours& neighbours, double reach) : neighbours_(neighbours), reach_(reach) {}

  /// Computes phi of a site. `normal` is a unit vector. Throws SampleError if no other point limits the cell of `site`.
  /// O(log n) typically.
  CellRadius operator()(Index site, const Vec3& normal);

  /// Return the cell of the last call, in its tangent plane, and the place in space of a corner of it.
  const PlanarCell& cell() const noexcept { return cell_; }
  Vec3 position(const CellCorner& corner) const { return origin_ + corner.x * u_ + corner.y * v_; }

 private:
  bool cut(Index other);
  bool cut_by_near(Index site);
  void cut_by_far(Index site);

  const Neighbours& neighbours_;
  const double reach_;
  PlanarCell cell_;
  Vec3 origin_, u_, v_;  // of the tangent plane
  std::vector<Neighbour> found_;
  std::vector<Index> tried_;
};

}  // namespace geodrome
