// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "geodrome/surface.hpp"

/// Straight lines over a mesh: from a point back towards a source, face by face.
namespace geodrome {

/// Where a straight line leaves a face.
struct Ray {
  Index half_edge = no_index;  ///< of the face that it leaves
  double share = 0;            ///< of the half-edge, from its begin
  Vec3 direction;              ///< in the plane of that face
};

/// A ray from a point of a face, in its plane or nearly. Returns nothing if it leaves the face at once.
std::optional<Ray> ray_from(const SurfaceMesh& mesh, const SurfacePoint& from, const Vec3& direction);

/// A ray from a vertex into that of its faces, named by the half-edges that start there, which holds most of it.
std::optional<Ray> ray_from(const SurfaceMesh& mesh, std::span<const Index> starting, const Vec3& direction);

/// The ray in the face behind the edge, unfolded. Returns nothing at a border.
std::optional<Ray> next_face(const SurfaceMesh& mesh, const Ray& ray);

}  // namespace geodrome
