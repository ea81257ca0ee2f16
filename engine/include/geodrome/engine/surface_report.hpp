// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace geodrome {

/// Facts about a surface: topology, and the shapes of its triangles.
struct SurfaceFacts {
  std::size_t vertices = 0, faces = 0, components = 0, boundary_loops = 0;
  bool manifold = false, oriented = false, closed = false;
  long euler_number = 0;
  std::optional<long> genus;       ///< summed over components; of manifold, orientable surfaces
  double smallest_angle = 0;       ///< radians; over all faces
  double largest_edge_ratio = 1;   ///< longest to shortest edge of a face; +inf if a face has an edge of length 0
  std::size_t largest_degree = 0;  ///< edges at a vertex
};

/// A report on a surface and on how it came about.
struct SurfaceReport {
  SurfaceFacts facts;
  /// Experience says so of a sample, and why: "good", "fair", "doubtful" or "unknown"; empty for a mesh.
  std::string practice;
  std::vector<std::string> practice_because;
  std::string json;  ///< all that reports say of it: "surface", "stages", of a sample "sample", "practice" and more
};

}  // namespace geodrome
