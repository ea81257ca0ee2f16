// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <set>
#include <vector>

#include "geodrome/surface_reconstructor.hpp"
#include "geodrome/vertex_components.hpp"

namespace geodrome::test {

/// What a surface is, whatever its triangles.
struct Topology {
  long euler = 0;
  std::size_t boundary_edges = 0, components = 0;
  bool operator==(const Topology&) const = default;
};

inline std::ostream& operator<<(std::ostream& out, const Topology& t) {
  return out << "Euler number " << t.euler << ", " << t.boundary_edges << " boundary edges, " << t.components
             << " components";
}

/// The faces as sets of sample points, by other names of these if there are any.
inline std::set<std::set<Index>> faces_of(const Reconstruction& made, const std::vector<Index>& name = {}) {
  std::set<std::set<Index>> faces;
  for (const Triangle& t : made.mesh->triangles()) {
    std::set<Index> face;
    for (const Index v : t) face.insert(name.empty() ? made.sample_of_vertex[v] : name[made.sample_of_vertex[v]]);
    faces.insert(face);
  }
  return faces;
}

inline Topology topology(const SurfaceMesh& mesh) {
  Topology t;
  for (const Index twin : mesh.twins()) t.boundary_edges += twin == no_index;
  const std::size_t edges = (3 * mesh.face_count() + t.boundary_edges) / 2;
  t.euler = static_cast<long>(mesh.vertex_count()) - static_cast<long>(edges) + static_cast<long>(mesh.face_count());
  const std::vector<Index> component = vertex_components(mesh);
  for (Index v = 0; v < component.size(); ++v) t.components += component[v] == v;
  return t;
}

}  // namespace geodrome::test
