// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// Where faces meet at a vertex in several fans, keeps the largest (ties: of the lowest face) and drops the others,
/// until every vertex has one fan. Returns how many faces were dropped. Nothing is done if an edge has over two faces.
std::size_t drop_minor_fans(std::vector<Triangle>& faces, std::size_t vertex_count);

/// Turns every closed component so that its faces run counter-clockwise seen from outside (positive volume).
/// The faces must be a manifold and oriented.
void orient_outwards(std::vector<Triangle>& faces, std::span<const Vec3> points);

struct BoundaryFacts {
  std::size_t loops = 0, components = 0;
  std::vector<Index> some_vertices;  ///< the first few on a boundary
};

/// Loops and components of a manifold mesh.
BoundaryFacts boundary_facts(const SurfaceMesh& mesh);

}  // namespace geodrome
