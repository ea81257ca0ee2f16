// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/input/polygons.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome::input {

/// Counts the defects and the topology of a mesh into `input.facts`, and tells of them in `input.findings`. Changes
/// nothing else. Precondition: positions and triangles of `input` are set. O(n log n).
void check_mesh(const Polygons& polygons, Input& input);

/// The topology of a triangle mesh, from its edges and corners, as in InputFacts.
struct Topology {
  Finding nonmanifold_edges, nonmanifold_vertices;  ///< elements: vertices
  Finding boundary_edges;                           ///< elements: vertices
  Finding clashes;                                  ///< edges whose two faces run the same way; elements: triangles
  std::vector<std::array<Index, 2>> open_edges;     ///< the vertices of the boundary edges
  std::size_t edges = 0, vertices = 0, components = 0, boundary_loops = 0;
  bool orientable = true;
};
Topology topology_of(const std::vector<Triangle>& triangles, std::size_t vertex_count);

}  // namespace geodrome::input
