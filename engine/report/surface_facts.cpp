// SPDX-License-Identifier: MIT
#include "engine/report/surface_facts.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "engine/input/mesh_check.hpp"

namespace geodrome {

namespace {

void add_shape(const std::array<Vec3, 3>& p, SurfaceFacts& facts) {
  const std::array<double, 3> length{distance(p[1], p[2]), distance(p[2], p[0]), distance(p[0], p[1])};
  const double twice_area = norm(cross(p[1] - p[0], p[2] - p[0]));
  for (int i = 0; i < 3; ++i)
    facts.smallest_angle =
        std::min(facts.smallest_angle, std::atan2(twice_area, dot(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i])));
  const auto [shortest, longest] = std::minmax_element(length.begin(), length.end());
  facts.largest_edge_ratio = std::max(facts.largest_edge_ratio, *longest / *shortest);
  facts.largest_circumradius =
      std::max(facts.largest_circumradius, length[0] * length[1] * length[2] / (2 * twice_area));
}

std::size_t largest_degree(const SurfaceMesh& mesh) {
  std::vector<std::size_t> degree(mesh.vertex_count());
  const auto uses = detail::sorted_edge_uses(mesh.triangles());
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const bool repeated = i > 0 && uses[i].low == uses[i - 1].low && uses[i].high == uses[i - 1].high;
    if (!repeated) ++degree[uses[i].low], ++degree[uses[i].high];
  }
  return *std::max_element(degree.begin(), degree.end());
}

}  // namespace

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
  facts.largest_degree = largest_degree(mesh);
  facts.smallest_angle = std::numbers::pi;
  for (Index f = 0; f < mesh.face_count(); ++f) add_shape(mesh.corners(f), facts);
  return facts;
}

}  // namespace geodrome
