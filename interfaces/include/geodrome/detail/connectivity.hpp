// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome::detail {

/// The connectivity that follows from the triangles alone. Half-edge 3 f + i runs from corner i of face f to corner i +
/// 1.
struct Connectivity {
  std::vector<Index> twins;            ///< per half-edge; no_index on the boundary; empty if an edge has over two faces
  std::vector<Index> first_half_edge;  ///< per vertex: the lowest half-edge that starts there; no_index if none
  bool manifold = true, oriented = true, closed = true;
};

/// Disjoint sets with path halving; the lowest element represents its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index find(Index element) {
    while (parent_[element] != element) element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void unite(Index a, Index b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

/// A half-edge under its undirected edge, so that sorting brings the faces of an edge together.
struct EdgeUse {
  Index low, high, half_edge;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

inline std::vector<EdgeUse> sorted_edge_uses(std::span<const std::array<Index, 3>> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (Index f = 0; f < triangles.size(); ++f)
    for (Index i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[f][i], triangles[f][(i + 1) % 3]);
      uses.push_back({low, high, 3 * f + i});
    }
  std::sort(uses.begin(), uses.end());
  return uses;
}

/// True if the faces around every vertex form one fan: no bow-ties. Corners are joined across every shared edge; a
/// vertex whose corners stay in several sets has several fans.
inline bool one_fan_per_vertex(std::span<const std::array<Index, 3>> triangles, std::span<const Index> twins,
                               std::size_t vertex_count) {
  const auto vertex = [&](Index corner) { return triangles[corner / 3][corner % 3]; };
  const auto next = [](Index h) { return h % 3 == 2 ? h - 2 : h + 1; };
  DisjointSets fans(twins.size());
  for (Index h = 0; h < twins.size(); ++h) {
    const Index t = twins[h];
    if (t == no_index || t < h) continue;
    const bool opposite = vertex(h) != vertex(t);
    fans.unite(h, opposite ? next(t) : t);
    fans.unite(next(h), opposite ? t : next(t));
  }
  std::vector<Index> fan_of_vertex(vertex_count, no_index);
  for (Index corner = 0; corner < twins.size(); ++corner) {
    Index& fan = fan_of_vertex[vertex(corner)];
    if (fan == no_index) fan = fans.find(corner);
    if (fan != fans.find(corner)) return false;
  }
  return true;
}

/// O(F log F). Precondition: indices below `vertex_count`, three different ones a triangle.
inline Connectivity connect(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count) {
  Connectivity result;
  result.twins.assign(3 * triangles.size(), no_index);
  result.first_half_edge.assign(vertex_count, no_index);
  for (Index h = 3 * static_cast<Index>(triangles.size()); h-- > 0;)
    result.first_half_edge[triangles[h / 3][h % 3]] = h;

  const std::vector<EdgeUse> uses = sorted_edge_uses(triangles);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i == 1) result.closed = false;
    if (end - i > 2) result.manifold = false;
    if (end - i != 2) continue;
    const Index a = uses[i].half_edge, b = uses[i + 1].half_edge;
    result.twins[a] = b, result.twins[b] = a;
    if (triangles[a / 3][a % 3] == triangles[b / 3][b % 3]) result.oriented = false;
  }
  if (!result.manifold) {
    result.twins.clear();
    result.oriented = false;
  } else {
    result.manifold = one_fan_per_vertex(triangles, result.twins, vertex_count);
  }
  return result;
}

}  // namespace geodrome::detail
