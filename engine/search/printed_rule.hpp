// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// The nearest vertex among those that faces use: an R-tree. Immutable; thread-safe.
class VertexLocator {
 public:
  /// O(V log V).
  explicit VertexLocator(const SurfaceMesh& mesh);
  ~VertexLocator();

  /// Ties go to the lowest vertex. O(log V) typically.
  Index nearest(const Vec3& query) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// Algorithm 2, lines 17 and 18: on every face at `vertex` the point that is closest to `query`. O(degree).
/// Precondition: an oriented manifold.
std::vector<SurfacePoint> closest_on_faces_at(const SurfaceMesh& mesh, Index vertex, const Vec3& query);

}  // namespace geodrome
