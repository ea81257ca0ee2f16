// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "geodrome/solver_kit/packed_mesh.hpp"

namespace geodrome {

/// Returns place x of a half-edge in the frame of `parent`, a half-edge of a face below: one that has another half-edge
/// on the same edge. O(faces at the edge).
inline std::pair<double, double> on_face_below(const PackedMesh& surface, Index half_edge, double x, Index parent) {
  const PackedMesh::Face& face = surface.face_of(parent);
  for (const Index edge : {SurfaceMesh::previous(parent), SurfaceMesh::next(parent)}) {
    double along = -1;
    surface.for_each_across(edge, [&](Index other, bool mirrored) {
      if (other == half_edge) along = mirrored ? x : surface.length(edge) - x;
    });
    if (along < 0) continue;
    const double share = face.length[edge % 3] > 0 ? along / face.length[edge % 3] : 0;
    std::array<double, 3> b{};
    b[edge % 3] = 1 - share;
    b[(edge + 1) % 3] = share;
    return surface.in_frame(parent, b);
  }
  return {x, 0};
}

}  // namespace geodrome
