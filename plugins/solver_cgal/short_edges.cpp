// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/solver_cgal/short_edges.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "geodrome/errors.hpp"

namespace geodrome::cgal {

namespace {

/// More than the rounding of a sum of angles: a vertex that is nearly flat counts as flat.
constexpr double slack_of_angles = 1e-9;

/// Which vertices start windows of their own.
std::vector<bool> starts_of_windows(const SurfaceMesh& mesh) {
  std::vector<double> angle(mesh.vertex_count());
  std::vector<bool> starts(mesh.vertex_count());
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Triangle& corners = mesh.triangles()[SurfaceMesh::face(h)];
    const Index v = corners[h % 3], next = corners[(h + 1) % 3], previous = corners[(h + 2) % 3];
    const Vec3 p = mesh.positions()[next] - mesh.positions()[v], q = mesh.positions()[previous] - mesh.positions()[v];
    angle[v] += std::atan2(norm(cross(p, q)), dot(p, q));
    if (mesh.twins()[h] == no_index) starts[v] = starts[next] = true;
  }
  for (Index v = 0; v < angle.size(); ++v)
    if (angle[v] >= 2 * std::numbers::pi - slack_of_angles) starts[v] = true;
  return starts;
}

double length_of(const SurfaceMesh& mesh, Index half_edge) {
  const Triangle& corners = mesh.triangles()[SurfaceMesh::face(half_edge)];
  return distance(mesh.positions()[corners[half_edge % 3]], mesh.positions()[corners[(half_edge + 1) % 3]]);
}

}  // namespace

std::vector<Index> edges_without_length(const SurfaceMesh& mesh, double rounding) {
  double longest = 0;  // a shortest path runs along no edge twice, and from inside a face it first goes to a corner
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) longest += length_of(mesh, h);
  const std::vector<bool> starts = starts_of_windows(mesh);
  std::vector<Index> found;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Triangle& corners = mesh.triangles()[SurfaceMesh::face(h)];
    const bool is_first = mesh.twins()[h] == no_index || h < mesh.twins()[h];
    if (is_first && starts[corners[h % 3]] && starts[corners[(h + 1) % 3]] && length_of(mesh, h) <= rounding * longest)
      found.push_back(h);
  }
  return found;
}

void require_lengths(const SurfaceMesh& mesh, double rounding) {
  const std::vector<Index> edges = edges_without_length(mesh, rounding);
  if (edges.empty()) return;
  const Index first = edges.front(), twin = mesh.twins()[first];
  const Index from = mesh.triangles()[first / 3][first % 3], to = mesh.triangles()[first / 3][(first + 1) % 3];
  throw CapabilityError("CGAL's search cannot take " + std::to_string(edges.size()) +
                            (edges.size() == 1 ? " edge" : " edges") +
                            " without length beside the distances, the first between vertices " + std::to_string(from) +
                            " and " + std::to_string(to) + " of face " + std::to_string(first / 3) +
                            (twin == no_index ? "" : " and face " + std::to_string(twin / 3)),
                        "merge the vertices at one place, or choose another exact solver (chen_han, schreiber)");
}

}  // namespace geodrome::cgal
