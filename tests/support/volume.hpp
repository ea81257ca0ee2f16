// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/surface.hpp"

namespace geodrome::test {

/// What a closed mesh encloses; positive if its faces look outwards.
inline double volume(const SurfaceMesh& mesh) {
  double six_volumes = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    six_volumes += dot(p, cross(q, r));
  }
  return six_volumes / 6;
}

}  // namespace geodrome::test
