// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "geodrome/surface.hpp"

namespace geodrome {

/// Returns the cost of a unit of length in a face: 1 on a mesh without weights.
inline double weight_of(const SurfaceMesh& mesh, Index face) {
  return mesh.face_weights().empty() ? 1 : mesh.face_weights()[face];
}

/// The smallest weight of a mesh: no distance is less than this times the straight line. O(F).
inline double smallest_weight(const SurfaceMesh& mesh) {
  return mesh.face_weights().empty() ? 1 : std::ranges::min(mesh.face_weights());
}

}  // namespace geodrome
