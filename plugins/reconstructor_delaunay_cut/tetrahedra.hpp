// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A 3D Delaunay triangulation as flat arrays. Infinite cells have the corner `no_index`, as their last or last but
/// one. The cells, and each cell's corners, are in an order that depends on the points alone.
struct Tetrahedra {
  using Cell = std::array<Index, 4>;

  std::vector<Cell> corners;     ///< positively oriented: facet_of(cell, i) looks outwards
  std::vector<Cell> neighbours;  ///< neighbours[c][i] shares the facet opposite corner i

  std::size_t size() const noexcept { return corners.size(); }
  /// The place of the facet neighbours[cell][i] shares, in that neighbour.
  int mirror(Index cell, int i) const;
  bool infinite(Index cell) const { return corners[cell][2] == no_index || corners[cell][3] == no_index; }
};

/// Corners of the facet opposite corner `i`, counter-clockwise seen from outside the cell.
inline std::array<Index, 3> facet_of(const Tetrahedra::Cell& cell, int i) {
  constexpr int corner[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  return {cell[corner[i][0]], cell[corner[i][1]], cell[corner[i][2]]};
}

/// Delaunay triangulation with exact predicates; cospherical points are decided by their lexicographic order (symbolic
/// perturbation). Points must be distinct. Empty if all points are in one plane. O(n log n) for points on a surface.
Tetrahedra delaunay_tetrahedra(std::span<const Vec3> points);

/// The cells around every point, as one list per point.
class CellsOfPoint {
 public:
  CellsOfPoint(const Tetrahedra& tetrahedra, std::size_t point_count);
  std::span<const Index> operator()(Index point) const {
    return {cells_.data() + first_[point], first_[point + 1] - first_[point]};
  }

 private:
  std::vector<Index> first_, cells_;
};

}  // namespace geodrome
