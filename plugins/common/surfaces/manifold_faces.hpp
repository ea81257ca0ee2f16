// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// Keeps the largest fan (ties: that of the lowest face) of every vertex at which faces meet in several, and drops the
/// others, until every vertex has one fan. Returns how many faces were dropped. Does nothing if an edge has over two
/// faces.
std::size_t drop_minor_fans(std::vector<Triangle>& faces, std::size_t vertex_count);

/// Lists the vertices at which faces meet in several fans, ascending. `twins` as in detail::Connectivity, not empty.
/// O(F).
std::vector<Index> split_vertices(std::span<const Triangle> faces, std::span<const Index> twins,
                                  std::size_t vertex_count);

/// Turns faces so that they run alike across every edge, each component as its lowest face does. Returns the half-edges
/// across which that cannot be, ascending: none if the faces can be oriented. `twins` as for split_vertices, of the
/// faces as they come. O(F).
std::vector<Index> orient_alike(std::vector<Triangle>& faces, std::span<const Index> twins);

/// Turns every closed component so that its faces run counter-clockwise seen from outside (positive volume).
/// The faces must be a manifold and oriented.
void orient_outwards(std::vector<Triangle>& faces, std::span<const Vec3> points);

struct BoundaryFacts {
  std::size_t loops = 0, components = 0;
  std::vector<Index> some_vertices;  ///< the first few on a boundary
};

/// Counts the boundary loops and the components of a manifold mesh.
BoundaryFacts boundary_facts(const SurfaceMesh& mesh);

}  // namespace geodrome
