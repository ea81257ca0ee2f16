// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/surface.hpp"
#include "tools/shapes/random.hpp"

/// What fuzz_mesh does to a mesh: see there. All keep at most two faces an edge, oriented.
namespace geodrome::shapes {

/// A mesh that can be changed.
struct Soup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;

  explicit Soup(const SurfaceMesh& mesh)
      : positions(mesh.positions().begin(), mesh.positions().end()),
        triangles(mesh.triangles().begin(), mesh.triangles().end()) {}
  SurfaceMesh mesh() const { return SurfaceMesh(positions, triangles); }
};

/// `other` beside the soup, not connected with it.
void append(Soup& soup, const Soup& other);
void stretch(Soup& soup, Random& random);
void jitter(Soup& soup, Random& random);
void pull_needles(Soup& soup, std::size_t count, Random& random);
/// Deletes up to `count` faces; a face whose deletion would give some vertex several fans stays.
void cut_holes(Soup& soup, std::size_t count, Random& random);
/// Deletes all faces around a vertex, which is left on no face, `count` times.
void cut_stars(Soup& soup, std::size_t count, Random& random);
/// Deletes every second face around `count` vertices, so that the others meet at the vertex alone.
void leave_touching_fans(Soup& soup, std::size_t count, Random& random);
/// Merges up to `count` pairs of vertices that share no face and no neighbour, in their middle.
void tie_bows(Soup& soup, std::size_t count, Random& random);
void renumber(Soup& soup, Random& random);

}  // namespace geodrome::shapes
