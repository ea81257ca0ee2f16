// SPDX-License-Identifier: MIT
#include "tools/shapes/refine.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "geodrome/quarter.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::shapes {
namespace {

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
  while (!triangles.empty() && triangles.size() < faces)
    quarter(positions, triangles, [](const Vec3& p, const Vec3& q) { return 0.5 * (p + q); });
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
