// SPDX-License-Identifier: MIT
#include "engine/checks/surface_facts.hpp"

#include <algorithm>
#include <numbers>

#include "engine/input/mesh_check.hpp"
#include "engine/surface/face_shape.hpp"

namespace geodrome {

namespace {

void add_shape(const FaceShape& shape, SurfaceFacts& facts) {
  for (const double angle : shape.angle) facts.smallest_angle = std::min(facts.smallest_angle, angle);
  facts.largest_edge_ratio = std::max(facts.largest_edge_ratio, shape.edge_ratio);
}

}  // namespace

std::vector<std::size_t> degrees_of(const SurfaceMesh& mesh) {
  std::vector<std::size_t> degree(mesh.vertex_count());
  const auto uses = detail::sorted_edge_uses(mesh.triangles());
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const bool repeated = i > 0 && uses[i].low == uses[i - 1].low && uses[i].high == uses[i - 1].high;
    if (!repeated) ++degree[uses[i].low], ++degree[uses[i].high];
  }
  return degree;
}

SurfaceFacts facts_of(const SurfaceMesh& mesh) {
  SurfaceFacts facts;
  const std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  const input::Topology topology = input::topology_of(triangles, mesh.vertex_count());
  facts.vertices = mesh.vertex_count(), facts.faces = mesh.face_count();
  facts.components = topology.components, facts.boundary_loops = topology.boundary_loops;
  facts.manifold = mesh.manifold(), facts.oriented = mesh.oriented(), facts.closed = mesh.closed();
  facts.euler_number =
      static_cast<long>(topology.vertices) - static_cast<long>(topology.edges) + static_cast<long>(facts.faces);
  if (facts.manifold && topology.orientable)
    facts.genus =
        (2 * static_cast<long>(facts.components) - static_cast<long>(facts.boundary_loops) - facts.euler_number) / 2;
  const std::vector<std::size_t> degrees = degrees_of(mesh);
  facts.largest_degree = *std::max_element(degrees.begin(), degrees.end());
  facts.smallest_angle = std::numbers::pi;
  for (Index f = 0; f < mesh.face_count(); ++f) add_shape(shape_of(mesh.corners(f)), facts);
  return facts;
}

}  // namespace geodrome
