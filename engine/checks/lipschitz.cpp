// SPDX-License-Identifier: MIT
#include "engine/checks/lipschitz.hpp"

#include "engine/surface/face_weight.hpp"

namespace geodrome {

SteepEdge steepest_edge(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit) {
  SteepEdge worst;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const Triangle& corners = mesh.triangles()[face];
    for (int i = 0; i < 3; ++i) {
      const Index a = corners[i], b = corners[(i + 1) % 3];
      const double way = weight_of(mesh, face) * distance(mesh.positions()[a], mesh.positions()[b]);
      for (const auto& [far, near] : {std::pair(a, b), std::pair(b, a)}) {
        const double excess = lipschitz_excess(vertices[far], vertices[near], way, factor, limit);
        if (excess > worst.excess) worst = {excess, far, near, face};
      }
    }
  }
  return worst;
}

std::vector<double> bounds_of_faces(const SurfaceMesh& mesh, std::span<const double> vertices) {
  std::vector<double> bounds(mesh.face_count());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const auto& [a, b, c] = mesh.triangles()[face];
    const auto [p, q, r] = mesh.corners(face);
    const double longest = std::max({distance(p, q), distance(q, r), distance(r, p)});
    bounds[face] = std::max({vertices[a], vertices[b], vertices[c]}) + weight_of(mesh, face) * longest;
  }
  return bounds;
}

}  // namespace geodrome
