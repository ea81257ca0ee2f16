// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/surface_points.hpp"

#include <cmath>

namespace geodrome::bench {

SurfacePoint random_inner_point(const SurfaceMesh& mesh, shapes::Random& random) {
  const auto face = static_cast<Index>(random.index(mesh.face_count()));
  // The square root makes the density even over the triangle (Turk 1990).
  const double root = std::sqrt(random.uniform()), along = random.uniform();
  return {face, {1 - root, root * (1 - along), root * along}};
}

SurfacePoint random_edge_point(const SurfaceMesh& mesh, shapes::Random& random) {
  SurfacePoint point{static_cast<Index>(random.index(mesh.face_count())), {}};
  const std::size_t corner = random.index(3);
  point.b[corner] = random.uniform();
  point.b[(corner + 1) % 3] = 1 - point.b[corner];
  return point;
}

SurfacePoint random_vertex(const SurfaceMesh& mesh, shapes::Random& random) {
  const Triangle& face = mesh.triangles()[random.index(mesh.face_count())];
  return mesh.at_vertex(face[random.index(3)]);
}

}  // namespace geodrome::bench
