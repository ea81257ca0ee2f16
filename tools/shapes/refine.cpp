// SPDX-License-Identifier: MIT
#include "tools/shapes/refine.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tools/shapes/random.hpp"

namespace geodrome::shapes {
namespace {

void quarter(std::vector<Vec3>& positions, std::vector<Triangle>& triangles) {
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, is_new] = middles.emplace(std::minmax(a, b), static_cast<Index>(positions.size()));
    if (is_new) positions.push_back(0.5 * (positions[a] + positions[b]));
    return entry->second;
  };
  std::vector<Triangle> finer;
  finer.reserve(4 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  triangles = std::move(finer);
}

/// A point of a triangle whose coordinates are at least 1/21: the weights before division lie between 0.1 and 1.
Vec3 random_inner_point(const Vec3& p, const Vec3& q, const Vec3& r, Random& random) {
  const double a = random.uniform(0.1, 1), b = random.uniform(0.1, 1), c = random.uniform(0.1, 1);
  // From differences, so that a mesh far from the origin keeps its shape.
  return p + (b / (a + b + c)) * (q - p) + (c / (a + b + c)) * (r - p);
}

}  // namespace

SurfaceMesh refine_by_midpoints(const SurfaceMesh& mesh, std::size_t faces) {
  std::vector<Vec3> positions(mesh.positions().begin(), mesh.positions().end());
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  while (!triangles.empty() && triangles.size() < faces) quarter(positions, triangles);
  return SurfaceMesh(std::move(positions), std::move(triangles));
}

SurfaceMesh refine_by_points(const SurfaceMesh& mesh, std::size_t faces, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> positions(mesh.positions().begin(), mesh.positions().end());
  std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
  while (!triangles.empty() && triangles.size() < faces) {
    const std::size_t face = random.index(triangles.size());
    const auto [a, b, c] = triangles[face];
    const auto inner = static_cast<Index>(positions.size());
    positions.push_back(random_inner_point(positions[a], positions[b], positions[c], random));
    triangles[face] = {a, b, inner};
    triangles.push_back({b, c, inner});
    triangles.push_back({c, a, inner});
  }
  return SurfaceMesh(std::move(positions), std::move(triangles));
}

}  // namespace geodrome::shapes
