// SPDX-License-Identifier: MIT
#include "plugins/solver_edge_dijkstra/edge_graph.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome {

double segment_length(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

EdgeGraph::EdgeGraph(const SurfaceMesh& mesh) : first_(mesh.vertex_count() + 1), next_on_edge_(3 * mesh.face_count()) {
  const std::vector<detail::EdgeUse> uses = detail::sorted_edge_uses(mesh.triangles());
  std::vector<std::pair<Index, Index>> edges;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    for (std::size_t i = begin; i < end; ++i)
      next_on_edge_[uses[i].half_edge] = uses[i + 1 < end ? i + 1 : begin].half_edge;
    edges.emplace_back(uses[begin].low, uses[begin].high);
  }
  for (const auto& [low, high] : edges) ++first_[low + 1], ++first_[high + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  arcs_.resize(2 * edges.size());
  std::vector<Index> end = first_;
  const std::span<const Vec3> at = mesh.positions();
  for (const auto& [low, high] : edges) {
    const double length = segment_length(at[low], at[high]);
    arcs_[end[low]++] = {high, length};
    arcs_[end[high]++] = {low, length};
  }
}

std::size_t EdgeGraph::bytes() const {
  return arcs_.size() * sizeof(Arc) + (first_.size() + next_on_edge_.size()) * sizeof(Index);
}

}  // namespace geodrome
