// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_chen_han/kept_windows.hpp"

namespace geodrome::chen_han {

/// Follows kept windows back to the source, face by face: each has the image of the pseudo-source in its own frame, so
/// no error adds up, and thin triangles do no harm. Points are appended with the mesh's own face numbers.
class PathTracer {
 public:
  PathTracer(const PackedMesh& surface, const Labels& labels, const KeptWindows& kept, std::vector<SurfacePoint>& out)
      : surface_(surface), labels_(labels), kept_(kept), out_(out) {}

  /// From a vertex, which is appended first unless it is a source itself. O(faces crossed x log windows).
  void from_vertex(Index vertex);
  /// From a point of the face of a window's half-edge, at (x, y) in its frame; the point itself is not appended.
  void from_point(Index window, double x, double y);

 private:
  Index through(Index window, double x, double y);

  const PackedMesh& surface_;
  const Labels& labels_;
  const KeptWindows& kept_;
  std::vector<SurfacePoint>& out_;
};

}  // namespace geodrome::chen_han
