// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "geodrome/surface.hpp"

namespace geodrome {

struct ClosestPoint {
  SurfacePoint at;
  double distance = 0;  ///< in space, units of the input
};

/// Closest surface points: an R-tree over triangle boxes with an exact point-triangle distance. Immutable; thread-safe.
class SurfaceLocator {
 public:
  /// Throws InputError (empty) for a mesh without faces. O(F log F).
  explicit SurfaceLocator(MeshPtr mesh);
  ~SurfaceLocator();

  /// The globally closest point of the surface; ties go to the lowest face. Faces in `without` (ascending) do not
  /// count: if no other is left, the face is no_index and the distance +inf. A point that is a vertex is found as that
  /// vertex, exactly (a barycentric coordinate equal to 1), even if a lower face passes through it. Degenerate faces
  /// count as the segments or points they are. Throws InputError (nonfinite) for a query that is not finite. O(log F)
  /// typically.
  ClosestPoint closest(const Vec3& query, std::span<const Index> without = {}) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace geodrome
