// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/feature_size.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "plugins/common/points/cell_radius.hpp"

namespace geodrome {
namespace {

constexpr double none = infinity;

/// Centre of the sphere through the corners; not finite for a cell that is flat.
Vec3 circumcentre(const Tetrahedra::Cell& cell, std::span<const Vec3> points) {
  const Vec3 &a = points[cell[0]], b = points[cell[1]] - a, c = points[cell[2]] - a, d = points[cell[3]] - a;
  const Vec3 up = squared_norm(b) * cross(c, d) + squared_norm(c) * cross(d, b) + squared_norm(d) * cross(b, c);
  return a + up / (2 * dot(b, cross(c, d)));
}

struct Pole {
  Vec3 centre;
  double radius = 0;  ///< distance from its point
};

/// Poles nearer to each other than this share of their radius count as one. A sphere's poles are all in its centre: the
/// search for the nearest of a million of these would look at every one.
constexpr double pole_grain = 0.01;

/// One pole for each box of a grid whose width is the grain of its radius, rounded down to a power of two.
std::vector<Vec3> thinned(const std::vector<Pole>& poles) {
  using Box = std::tuple<double, double, double, double>;
  std::vector<std::pair<Box, Vec3>> boxed;
  for (const Pole& pole : poles) {
    const double width = pole_grain * std::exp2(std::floor(std::log2(pole.radius)));
    const Vec3& c = pole.centre;
    boxed.push_back({{width, std::floor(c.x / width), std::floor(c.y / width), std::floor(c.z / width)}, c});
  }
  std::sort(boxed.begin(), boxed.end(), [](const auto& a, const auto& b) {
    const Vec3 &p = a.second, &q = b.second;
    return std::tie(a.first, p.x, p.y, p.z) < std::tie(b.first, q.x, q.y, q.z);
  });
  const auto same_box = [](const auto& a, const auto& b) { return a.first == b.first; };
  boxed.erase(std::unique(boxed.begin(), boxed.end(), same_box), boxed.end());
  std::vector<Vec3> centres;
  for (const auto& [box, centre] : boxed) centres.push_back(centre);
  return centres;
}

}  // namespace

std::vector<double> feature_sizes(const Tetrahedra& tetrahedra, const CellsOfPoint& cells_of, const Labels& inside,
                                  const OrientedPiece& piece) {
  // A pole farther off than the sample is wide, or at infinity, bounds no feature.
  const double farthest = sample_reach(piece.points);
  std::vector<Pole> poles;
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
      if (reach[side] > 0 && reach[side] < farthest) poles.push_back({pole[side], reach[side]});
  }
  std::vector<double> sizes(piece.points.size(), none);
  if (poles.empty()) return sizes;
  const Neighbours medial_axis(thinned(poles));
  std::vector<Neighbour> found;
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    medial_axis.nearest(piece.points[p], 1, found);
    sizes[p] = std::sqrt(found.front().squared_distance);
  }
  return sizes;
}

}  // namespace geodrome
