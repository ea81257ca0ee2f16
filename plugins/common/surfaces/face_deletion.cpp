// SPDX-License-Identifier: MIT
#include "plugins/common/surfaces/face_deletion.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <utility>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Positions play no part in connectivity.
Mesh half_edge_mesh(const std::vector<Triangle>& faces, std::size_t vertex_count) {
  Mesh mesh;
  for (std::size_t v = 0; v < vertex_count; ++v) mesh.add_vertex({0, 0, 0});
  for (const auto& [a, b, c] : faces) {
    const auto vertex = [](Index v) { return Mesh::VertexHandle(static_cast<int>(v)); };
    if (!mesh.add_face(vertex(a), vertex(b), vertex(c)).is_valid())
      throw NumericalError("a face does not fit into a half-edge mesh: the surface is no manifold");
  }
  return mesh;
}

using Fan = std::vector<Mesh::FaceHandle>;

/// Collects the faces around a vertex, a fan each time the boundary is met.
std::vector<Fan> fans_around(const Mesh& mesh, Mesh::VertexHandle v) {
  std::vector<Fan> fans;
  for (auto h = mesh.cvoh_ccwbegin(v), end = mesh.cvoh_ccwend(v); h != end; ++h) {
    if (mesh.is_boundary(*h))
      fans.emplace_back();
    else if (fans.empty())
      fans.push_back({mesh.face_handle(*h)});
    else
      fans.back().push_back(mesh.face_handle(*h));
  }
  // The walk may have begun amid a fan: everything before the first gap belongs to the last fan.
  const bool began_amid = !fans.empty() && !mesh.is_boundary(*mesh.cvoh_ccwbegin(v));
  if (began_amid && fans.size() > 1) {
    fans.back().insert(fans.back().end(), fans.front().begin(), fans.front().end());
    fans.erase(fans.begin());
  }
  std::erase_if(fans, [](const Fan& fan) { return fan.empty(); });
  return fans;
}

void keep_largest_fan(Mesh& mesh, Mesh::VertexHandle v) {
  std::vector<Fan> fans = fans_around(mesh, v);
  const auto better = [](const Fan& a, const Fan& b) {
    return a.size() != b.size() ? a.size() > b.size()
                                : *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
  };
  std::sort(fans.begin(), fans.end(), better);
  for (std::size_t i = 1; i < fans.size(); ++i)
    for (const Mesh::FaceHandle f : fans[i]) mesh.delete_face(f, false);
}

/// Goes on until every vertex has one fan: deleting fans at one vertex may part the faces at another.
void part_at_vertices(Mesh& mesh) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Mesh::VertexHandle v : mesh.all_vertices()) {
      if (mesh.is_isolated(v) || mesh.is_manifold(v)) continue;
      keep_largest_fan(mesh, v);
      changed = true;
    }
  }
}

}  // namespace

std::vector<Triangle> without_faces(const std::vector<Triangle>& faces, std::span<const Index> doomed,
                                    std::size_t vertex_count) {
  if (doomed.empty()) return faces;
  Mesh mesh = half_edge_mesh(faces, vertex_count);
  for (const Index f : doomed) mesh.delete_face(Mesh::FaceHandle(static_cast<int>(f)), false);
  part_at_vertices(mesh);
  std::vector<Triangle> left;
  for (Index f = 0; f < faces.size(); ++f)
    if (!mesh.status(Mesh::FaceHandle(static_cast<int>(f))).deleted()) left.push_back(faces[f]);
  return left;
}

}  // namespace geodrome
