// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/feature_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/common/points/cell_radius.hpp"

namespace geodrome {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// Centre of the sphere through the corners; not finite for a cell that is flat.
Vec3 circumcentre(const Tetrahedra::Cell& cell, std::span<const Vec3> points) {
  const Vec3 &a = points[cell[0]], b = points[cell[1]] - a, c = points[cell[2]] - a, d = points[cell[3]] - a;
  const Vec3 up = squared_norm(b) * cross(c, d) + squared_norm(c) * cross(d, b) + squared_norm(d) * cross(b, c);
  return a + up / (2 * dot(b, cross(c, d)));
}

std::vector<Vec3> distinct(std::vector<Vec3> points) {
  const auto before = [](const Vec3& a, const Vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

std::vector<double> feature_sizes(const Tetrahedra& tetrahedra, const CellsOfPoint& cells_of, const Labels& inside,
                                  const OrientedPiece& piece) {
  // A pole farther off than the sample is wide, or at infinity, bounds no feature.
  const double farthest = sample_reach(piece.points);
  std::vector<Vec3> poles;
  for (Index p = 0; p < piece.points.size(); ++p) {
    double reach[2] = {0, 0};
    Vec3 pole[2];
    for (const Index c : cells_of(p)) {
      const Vec3 centre =
          tetrahedra.infinite(c) ? Vec3{none, none, none} : circumcentre(tetrahedra.corners[c], piece.points);
      const double away = is_finite(centre) ? distance(centre, piece.points[p]) : none;
      if (away > reach[inside[c]]) reach[inside[c]] = away, pole[inside[c]] = centre;
    }
    for (const int side : {0, 1})
      if (reach[side] > 0 && reach[side] < farthest) poles.push_back(pole[side]);
  }
  std::vector<double> sizes(piece.points.size(), none);
  if (poles.empty()) return sizes;
  const Neighbours medial_axis(distinct(std::move(poles)));
  std::vector<Neighbour> found;
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    medial_axis.nearest(piece.points[p], 1, found);
    sizes[p] = std::sqrt(found.front().squared_distance);
  }
  return sizes;
}

}  // namespace geodrome
