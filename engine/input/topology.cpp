// SPDX-License-Identifier: MIT
#include "engine/input/findings.hpp"
#include "engine/input/mesh_check.hpp"
#include "geodrome/detail/connectivity.hpp"

namespace geodrome::input {
namespace {

using detail::DisjointSets;
using detail::EdgeUse;

constexpr Index next(Index half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }

std::size_t count_sets(DisjointSets& sets, const std::vector<bool>& is_member) {
  std::size_t count = 0;
  for (Index i = 0; i < is_member.size(); ++i) count += is_member[i] && sets.find(i) == i;
  return count;
}

// Joins what meets at the edges, edge by edge: corners into fans, the two sides of faces into sides of the surface,
// vertices into components and boundary loops.
class EdgeWalk {
 public:
  EdgeWalk(const std::vector<Triangle>& triangles, std::size_t vertex_count)
      : triangles_(triangles),
        fans_(3 * triangles.size()),
        sides_(2 * triangles.size()),
        components_(vertex_count),
        loops_(vertex_count),
        used_(vertex_count),
        on_boundary_(vertex_count) {}

  Topology run() {
    const std::vector<EdgeUse> uses = detail::sorted_edge_uses(triangles_);
    for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
      while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
      ++result_.edges;
      components_.unite(uses[i].low, uses[i].high);
      used_[uses[i].low] = used_[uses[i].high] = true;
      if (end - i == 1) border(uses[i]);
      if (end - i > 2) add_element(result_.nonmanifold_edges, uses[i].low);
      for (std::size_t k = i + 1; k < end; ++k) join_corners(uses[k - 1].half_edge, uses[k].half_edge);
      if (end - i == 2) join_sides(uses[i].half_edge, uses[i + 1].half_edge);
    }
    count();
    return std::move(result_);
  }

 private:
  Index from(Index half_edge) const { return triangles_[half_edge / 3][half_edge % 3]; }

  void border(const EdgeUse& use) {
    add_element(result_.boundary_edges, use.low);
    result_.open_edges.push_back({use.low, use.high});
    on_boundary_[use.low] = on_boundary_[use.high] = true;
    loops_.unite(use.low, use.high);
  }

  void join_corners(Index h, Index t) {
    const bool opposite = from(h) != from(t);
    fans_.unite(h, opposite ? next(t) : t);
    fans_.unite(next(h), opposite ? t : next(t));
  }

  // Side 2 f is the front of face f, 2 f + 1 its back. The front of a face goes on in the front of a neighbour that
  // runs the other way along their edge, and in the back of one that runs the same way.
  void join_sides(Index h, Index t) {
    const bool clash = from(h) == from(t);
    if (clash) add_element(result_.clashes, h / 3);
    const Index f = 2 * (h / 3), g = 2 * (t / 3) + (clash ? 1 : 0);
    sides_.unite(f, g);
    sides_.unite(f ^ 1, g ^ 1);
  }

  void count() {
    std::vector<Index> fan_of_vertex(used_.size(), no_index);
    std::vector<bool> pinched(used_.size());
    for (Index corner = 0; corner < 3 * triangles_.size(); ++corner) {
      Index& fan = fan_of_vertex[from(corner)];
      if (fan == no_index) fan = fans_.find(corner);
      if (fan != fans_.find(corner)) pinched[from(corner)] = true;
    }
    for (Index v = 0; v < pinched.size(); ++v)
      if (pinched[v]) add_element(result_.nonmanifold_vertices, v);
    for (Index f = 0; f < triangles_.size(); ++f)
      if (sides_.find(2 * f) == sides_.find(2 * f + 1)) result_.orientable = false;
    result_.components = count_sets(components_, used_);
    result_.boundary_loops = count_sets(loops_, on_boundary_);
    for (const bool used : used_) result_.vertices += used;
  }

  const std::vector<Triangle>& triangles_;
  DisjointSets fans_, sides_, components_, loops_;
  std::vector<bool> used_, on_boundary_;
  Topology result_;
};

}  // namespace

Topology topology_of(const std::vector<Triangle>& triangles, std::size_t vertex_count) {
  return EdgeWalk(triangles, vertex_count).run();
}

}  // namespace geodrome::input
