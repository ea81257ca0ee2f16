// SPDX-License-Identifier: MIT
#include "tools/shapes/split_vertices.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "tools/shapes/random.hpp"

namespace geodrome::shapes {
namespace {

/// Returns the vertices around a vertex in the order of its faces; none if these do not close.
std::vector<Index> ring_around(const std::vector<Triangle>& triangles, Index vertex) {
  std::map<Index, Index> following;
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] == vertex) following[t[(i + 1) % 3]] = t[(i + 2) % 3];
  std::vector<Index> ring;
  if (following.empty()) return ring;
  for (Index next = following.begin()->first; ring.size() < following.size();) {
    ring.push_back(next);
    const auto found = following.find(next);
    if (found == following.end()) return {};
    next = found->second;
  }
  return following[ring.back()] == ring.front() ? ring : std::vector<Index>{};
}

/// Gives the faces of `old` that begin at the first half of its ring to `fresh`, and fills the slit between the two.
void split(std::vector<Triangle>& triangles, Index old, Index fresh, const std::vector<Index>& ring) {
  const std::size_t half = ring.size() / 2;
  for (Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const auto begin = std::find(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(half), t[(i + 1) % 3]);
      if (t[i] == old && begin != ring.begin() + static_cast<std::ptrdiff_t>(half)) t[i] = fresh;
    }
  triangles.push_back({old, ring[0], fresh});
  triangles.push_back({old, fresh, ring[half]});
}

}  // namespace

SurfaceMesh split_vertices(const SurfaceMesh& mesh, std::size_t count, double gap, std::uint64_t seed) {
  std::vector<Vec3> positions(mesh.positions().begin(), mesh.positions().end());
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const auto old = static_cast<Index>(random.index(positions.size()));
    const Vec3 way{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
    const std::vector<Index> ring = ring_around(triangles, old);
    if (ring.size() < 4) continue;
    split(triangles, old, static_cast<Index>(positions.size()), ring);
    positions.push_back(positions[old] + gap / norm(way) * way);
  }
  return {std::move(positions), std::move(triangles)};
}

}  // namespace geodrome::shapes
