// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "geodrome/surface_reconstructor.hpp"

namespace geodrome {

/// The change of a mesh by the insertion of a point: its star. The point is vertex number `mesh.vertex_count()`.
struct LocalChange {
  std::vector<std::pair<Index, Triangle>> replaced;  ///< faces that get other corners, ascending
  std::vector<Triangle> added;                       ///< faces behind those of the mesh; never none
  Insertion how = Insertion::cavity;
};

/// Inserts `point` where the surface is closest to it, `closest`, by local re-triangulation (Section 2.4).
///
/// The face or the edge that holds `closest` is split at the point; beyond a boundary the boundary edge gets a face
/// instead. Then, as in Lawson's algorithm, an edge opposite to the point is flipped while the smallest sphere through
/// the corners of the face behind it holds the point: the result is the star of the cavity of such faces. (The sphere
/// and not the circle in the face's plane: it leaves out faces of another sheet and of a slope far off, and turns into
/// the restricted Delaunay ball as the sample gets denser.) A flip is refused if it would lose a vertex, turn a face by
/// more than 60 degrees, or cut off a crease. So the topology stays, and the result is an oriented manifold whatever
/// happens.
///
/// Precondition: `mesh` is an oriented manifold; the point is no vertex of it. The cavity alone is copied, to an
/// OpenMesh mesh: O(c^2) for c faces, independent of the mesh. Thread-safe.
LocalChange insert_point(const SurfaceMesh& mesh, const Vec3& point, const SurfacePoint& closest);

}  // namespace geodrome
