// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"
#include "plugins/common/points/planar_stars.hpp"

namespace geodrome {

/// The triangles of all planar stars, each once, ascending by their sorted corners.
struct StarUnion {
  std::vector<Triangle> faces;  ///< counter-clockwise around the normal of the lowest corner in whose star they are
  std::vector<Index> disputed;  ///< faces that are not in the stars of all their corners
};

/// Section 2.3 as printed. Triangles whose centre is farther than `farthest[s]` from s do not count as those of the
/// star of s. Nothing else is left out, and nothing is added. O(n log n).
StarUnion union_of(const PlanarStars& stars, std::span<const Vec3> points, std::span<const double> farthest);

}  // namespace geodrome
