// SPDX-License-Identifier: MIT
#include "engine/checks/lipschitz.hpp"

#include "engine/surface/face_weight.hpp"

namespace geodrome {

MisfitVertex worst_too_far(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit) {
  MisfitVertex worst;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const Triangle& corners = mesh.triangles()[face];
    for (int i = 0; i < 3; ++i) {
      const Index a = corners[i], b = corners[(i + 1) % 3];
      const double way = weight_of(mesh, face) * distance(mesh.positions()[a], mesh.positions()[b]);
      for (const auto& [far, near] : {std::pair(a, b), std::pair(b, a)}) {
        const double excess = lipschitz_excess(vertices[far], vertices[near], way, factor, limit);
        if (excess > worst.excess) worst = {excess, far, face};
      }
    }
  }
  return worst;
}

MisfitVertex worst_too_near(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit,
                            std::span<const Source> sources) {
  const double least_weight = smallest_weight(mesh);
  std::vector<double> least(mesh.vertex_count(), infinity);
  std::vector<Index> face_of(mesh.vertex_count(), no_index);
  for (Index face = 0; face < mesh.face_count(); ++face)
    for (int i = 0; i < 3; ++i) {
      const Triangle& corners = mesh.triangles()[face];
      const Index v = corners[i], a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
      if (least[v] <= vertices[v]) continue;  // one way to it is enough
      const Vec3 &p = mesh.positions()[a], &q = mesh.positions()[b];
      // The bounds by a and by b meet where the distance may be least, since the way to v changes less than either.
      const double length = distance(p, q), edge = weight_of(mesh, face) * length;
      const double from_a = std::min(vertices[a], limit) / factor, from_b = std::min(vertices[b], limit) / factor;
      const double s = edge > 0 ? std::clamp((from_a - from_b + edge) / (2 * edge), 0.0, 1.0) : 0;
      const double there = std::max(from_a - s * edge, from_b - (1 - s) * edge);
      const double reached = there + least_weight * distance(p + s * (q - p), mesh.positions()[v]);
      if (reached < least[v]) least[v] = reached, face_of[v] = face;
    }
  for (const Source& source : sources)
    for (int i = 0; i < 3; ++i)
      if (source.at.b[i] > 0) least[mesh.triangles()[source.at.face][i]] = -infinity;
  MisfitVertex worst;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (vertices[v] < infinity && face_of[v] != no_index && least[v] - vertices[v] > worst.excess)
      worst = {least[v] - vertices[v], v, face_of[v]};
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
