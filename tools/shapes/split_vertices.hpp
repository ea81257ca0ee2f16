// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "geodrome/surface.hpp"

namespace geodrome::shapes {

/// Splits up to `count` seeded inner vertices in two, which lie `gap` apart in a seeded direction: half of the faces
/// around a vertex go to the new one, and two faces fill the slit. Old vertices keep their numbers and places, new ones
/// follow; distances between old ones change by less than 2 `gap` a split. A split vertex may be split again, so that
/// several lie next to each other. Vertices with fewer than four faces, and those on the boundary, are left out.
/// Precondition: a manifold, oriented mesh. O(count F).
SurfaceMesh split_vertices(const SurfaceMesh& mesh, std::size_t count, double gap, std::uint64_t seed);

}  // namespace geodrome::shapes
