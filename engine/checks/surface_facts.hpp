// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// What a surface is: topology, and the shapes of its triangles.
struct SurfaceFacts {
  std::size_t vertices = 0, faces = 0, components = 0, boundary_loops = 0;
  bool manifold = false, oriented = false, closed = false;
  long euler_number = 0;
  std::optional<long> genus;       ///< summed over components; of manifold, orientable surfaces
  double smallest_angle = 0;       ///< radians; over all faces
  double largest_edge_ratio = 1;   ///< longest to shortest edge of a face; +inf if a face has an edge of length 0
  std::size_t largest_degree = 0;  ///< edges at a vertex
};

/// Edges at each vertex. O(F log F).
std::vector<std::size_t> degrees_of(const SurfaceMesh& mesh);

/// O(F log F).
SurfaceFacts facts_of(const SurfaceMesh& mesh);

}  // namespace geodrome
