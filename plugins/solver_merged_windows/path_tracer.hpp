// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_merged_windows/kept_windows.hpp"
#include "plugins/solver_merged_windows/upper_bounds.hpp"

namespace geodrome::merged_windows {

/// Follows kept windows back to the source, face by face. Where a window was merged, the path goes on at the place
/// where it crosses the half-edge, along the line of the old window that has that place; at a vertex, by the way that D
/// had there when the window or the edge set out. So it is never longer than U, and leads to the source that U names.
/// Points are appended with the mesh's own face numbers.
class PathTracer {
 public:
  PathTracer(const PackedMesh& surface, const UpperBounds& upper, const KeptWindows& kept,
             std::vector<SurfacePoint>& out)
      : surface_(surface), upper_(upper), kept_(kept), out_(out) {}

  /// From a vertex, which is appended first unless it is a source itself. O(faces crossed x log windows).
  void from_vertex(Index vertex);
  /// From a point of the face of a window's half-edge, at (x, y) in its frame; the point itself is not appended.
  void from_point(Index window, double x, double y);

 private:
  void along(Index way);
  Index through(Index window, double x, double y);
  Index unmerged(Index window, Index half_edge, double place) const;

  const PackedMesh& surface_;
  const UpperBounds& upper_;
  const KeptWindows& kept_;
  std::vector<SurfacePoint>& out_;
};

}  // namespace geodrome::merged_windows
