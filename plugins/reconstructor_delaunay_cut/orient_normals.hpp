// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "plugins/common/points/planar_stars.hpp"

namespace geodrome {

/// The pieces of a sample that planar cells connect, and its normals, turned to one side of each piece.
struct OrientedSample {
  std::vector<Vec3> normals;
  std::vector<std::vector<Index>> pieces;  ///< ascending points of each, by their lowest point
};

/// Turns `normals` so that neighbours agree, along a maximal spanning forest of |n.n'| over the adjacency of the planar
/// cells (Hoppe et al. 1992, with this graph in place of nearest neighbours, which connects sheets that are close), and
/// each piece so that the normals at its extreme points look outwards. Neighbours farther apart than `edge_bound` times
/// the smaller psi are not connected. O(n log n).
OrientedSample orient(const PlanarStars& stars, std::span<const Vec3> points, std::span<const Vec3> normals,
                      std::span<const double> psi, double edge_bound);

}  // namespace geodrome
