// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/neighbours.hpp"

namespace geodrome {

/// A neighbour across an edge of the planar cell, and the corner in which the edge begins: the circumcentre, in the
/// tangent plane, of the star's triangle (site, previous neighbour, this neighbour) if `real`.
struct StarCorner {
  Index site = no_index;
  bool real = false;
  Vec3 centre;
};

/// The planar star of every point: the triangles with the neighbours whose cells meet its cell in its tangent plane
/// (Section 2.3, lines 1 to 3 of the restricted Delaunay tetrahedrization). The paper's surface is the union of the
/// stars; they agree on a triangle when all three corners have it.
///
/// A star has every triangle among points of which more than three are equally near to a corner of a cell (cocircular
/// ties, as in lattices), since either way to split them serves as well.
///
/// Indices are those of the points of `neighbours`. Immutable; thread-safe.
class PlanarStars {
 public:
  /// Builds the stars. Unit `normals`, one per point; `reach` as for CellRadiusFinder. At least two points. O(n log n).
  PlanarStars(const Neighbours& neighbours, std::span<const Vec3> normals, double reach, RunContext& context,
              ProgressShare share);

  std::size_t size() const noexcept { return first_.size() - 1; }

  /// Returns the neighbours of a point, counter-clockwise around its normal.
  std::span<const StarCorner> operator()(Index point) const {
    return {corners_.data() + first_[point], first_[point + 1] - first_[point]};
  }

  /// Tells whether the star of `point` has the triangle with `a` and `b`, in either order. O(neighbours).
  bool has(Index point, Index a, Index b) const { return in_ring(point, a, b) || in_tie(point, a, b); }

  /// Counts the corners of a triangle whose stars have it; `by_ties` tells whether it takes ties to find any of these.
  int holders(const std::array<Index, 3>& triangle, bool* by_ties = nullptr) const;

  /// Returns the distance that the cell of a point reaches, as CellRadius::phi; uncapped.
  double radius(Index point) const { return radius_[point]; }
  bool bounded(Index point) const { return bounded_[point] != 0; }

 private:
  bool in_ring(Index point, Index a, Index b) const;
  bool in_tie(Index point, Index a, Index b) const;
  void find_ties(const Neighbours& neighbours, const std::vector<Index>& order, RunContext& context,
                 ProgressShare share);

  std::vector<std::size_t> first_;
  std::vector<StarCorner> corners_;
  std::vector<double> radius_;
  std::vector<char> bounded_;
  std::vector<std::vector<std::vector<Index>>> ties_;  // per point: groups of points equally near to a corner
};

/// The agreement of the stars. A triangle that not all its corners have, ties counted, is inconsistent. Triangles whose
/// centre is too far from the point to be a face, as at a boundary, do not count.
struct StarAgreement {
  double inconsistent = 0;    ///< share of the triangles that need no ties
  double ties = 0;            ///< share of all triangles
  std::vector<Index> places;  ///< points with an inconsistent triangle, ascending
};

/// Measures the agreement. `farthest` is, per point, how far the centre of a triangle that counts may be. O(n log n).
StarAgreement agreement(const PlanarStars& stars, std::span<const Vec3> points, std::span<const double> farthest);

}  // namespace geodrome
