// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geodrome/surface.hpp"

/// Finer meshes of the same surface: new vertices lie in the faces they cut, so that every distance stays what it is up
/// to the rounding of their coordinates. The vertices of the mesh keep their numbers and places; face weights are
/// dropped.
namespace geodrome::shapes {

/// Every face becomes four by the middles of its edges, again and again until there are at least `faces`. Any mesh.
SurfaceMesh refine_by_midpoints(const SurfaceMesh& mesh, std::size_t faces);

/// One seeded face at a time becomes three by a seeded point inside it, until there are at least `faces`. Edges are
/// never cut, so that needles get ever thinner. The coordinates of a new point are at least 1/21.
SurfaceMesh refine_by_points(const SurfaceMesh& mesh, std::size_t faces, std::uint64_t seed);

}  // namespace geodrome::shapes
