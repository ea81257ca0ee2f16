// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <tuple>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/labels.hpp"

namespace geodrome {

/// A face seen from one of its half-edges: start A, end B, the third corner C, its apex, at (x, y). Whatever enters
/// through the half-edge leaves through the edge from C to A on its left or the edge from B to C on its right.
struct Apex {
  Index half_edge;
  const PackedMesh::Face& face;
  int a, b, c;  ///< corners of the face
  double length, x, y;

  Apex(const PackedMesh& surface, Index h)
      : half_edge(h), face(surface.face_of(h)), a(h % 3), b((a + 1) % 3), c((a + 2) % 3), length(face.length[a]) {
    std::tie(x, y) = PackedMesh::apex(face, a);
  }
  Index start() const { return face.vertex[a]; }
  Index end() const { return face.vertex[b]; }
  Index vertex() const { return face.vertex[c]; }
  Index left() const { return SurfaceMesh::previous(half_edge); }
  Index right() const { return SurfaceMesh::next(half_edge); }
  double left_length() const { return face.length[c]; }
  double right_length() const { return face.length[b]; }
  bool left_is_boundary() const { return face.across[c] == no_index; }
  bool right_is_boundary() const { return face.across[b] == no_index; }
  Angle angle(int corner) const { return {face.cosine[corner], face.sine[corner]}; }
  /// Returns the direction (dx, dy) from the apex into the face, as an angle from its left edge.
  Angle side(double dx, double dy) const { return angle_of(-x * dx - y * dy, std::max(0.0, y * dx - x * dy)); }
};

}  // namespace geodrome
