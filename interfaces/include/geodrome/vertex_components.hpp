// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// The connected component of every vertex, named by its lowest vertex. Faces that share a vertex are connected; a
/// vertex that no face uses is a component of its own. Two surface points have a distance if and only if the vertices
/// of their faces share a component. Indices below `vertex_count`. O(F).
inline std::vector<Index> vertex_components(std::span<const Triangle> triangles, std::size_t vertex_count) {
  detail::DisjointSets sets(vertex_count);
  for (const auto& [a, b, c] : triangles) sets.unite(a, b), sets.unite(a, c);
  std::vector<Index> component(vertex_count);
  for (Index v = 0; v < vertex_count; ++v) component[v] = sets.find(v);
  return component;
}

/// The components of all vertices of a mesh, as above. O(F).
inline std::vector<Index> vertex_components(const SurfaceMesh& mesh) {
  return vertex_components(mesh.triangles(), mesh.vertex_count());
}

}  // namespace geodrome
