// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// A component of a mesh with vertices and faces numbered from 0, in the mesh's order, and lengths times 2^exponent, so
/// that the mean edge is about 1 long: CGAL squares lengths and adds constants to them.
struct SurfacePart {
  std::vector<Index> vertex;  ///< of the mesh
  std::vector<Index> face;    ///< of the mesh
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  int exponent = 0;
  double mean_edge = 0;  ///< scaled; inner edges count twice

  double original(double length) const;
};

/// Where a vertex is.
struct PlaceInPart {
  Index part = no_index, vertex = no_index;
};

/// The components of a mesh. Vertices on no face are in none. Immutable.
class SurfaceParts {
 public:
  /// Throws InputError (range) for a component without extent or beyond the range of numbers. O(F).
  explicit SurfaceParts(const SurfaceMesh& mesh);

  const std::vector<SurfacePart>& parts() const { return parts_; }
  const PlaceInPart& place(Index vertex) const { return places_[vertex]; }
  /// The component of every vertex, as vertex_components names it.
  const std::vector<Index>& components() const { return components_; }
  std::size_t bytes() const;

 private:
  void normalise(SurfacePart& part, const SurfaceMesh& mesh);

  std::vector<Index> components_;
  std::vector<PlaceInPart> places_;
  std::vector<SurfacePart> parts_;
};

}  // namespace geodrome
