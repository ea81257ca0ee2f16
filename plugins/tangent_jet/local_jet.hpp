// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "plugins/common/points/neighbours.hpp"
#include "plugins/tangent_jet/quadric.hpp"

namespace geodrome {

/// How many nearest points of each point the outlier rules look at.
inline constexpr std::size_t near_count = 8;

/// What the neighbourhood of one point shows.
struct LocalJet {
  Vec3 plane_normal;                     ///< of the least-squares plane
  Vec3 normal;                           ///< of the quadric over that plane
  double residual = 0;                   ///< root mean square distance of the neighbours from the quadric
  double radius = 0;                     ///< distance of the farthest neighbour
  double d8 = 0;                         ///< distance of the 8th nearest point, or of the last there is
  std::array<Index, near_count> near{};  ///< the 8 nearest points; no_index where there are fewer
  bool grown = false;                    ///< whether k was not enough to show a plane
  bool collinear = false;                ///< all points are on a line: the normals mean nothing
};

/// The quadric over the plane with `normal` through `base`, fitted to the points `around` it, ascending in distance,
/// with weights exp(-decay d^2 / r^2), r being the distance of the last.
Quadric fit_quadric(const std::vector<Vec3>& points, const Vec3& base, const Vec3& normal,
                    const std::vector<Neighbour>& around, double decay);

/// The jet of point `at` from its `k` nearest points and itself; k grows as `grown_plane` says. `around` is a buffer.
LocalJet local_jet(const Neighbours& neighbours, Index at, std::size_t k, std::vector<Neighbour>& around);

}  // namespace geodrome
