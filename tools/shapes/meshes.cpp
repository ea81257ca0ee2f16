// SPDX-License-Identifier: MIT
#include "tools/shapes/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geodrome/quarter.hpp"
#include "tools/shapes/surface_net.hpp"

namespace geodrome::shapes {
namespace {

/// Columns and rows of quads of a patch's grid, and where its vertices stand in the array.
struct Layout {
  Index columns, rows, row_length;
  bool wraps, low_pole, high_pole;

  Layout(const Patch& patch, std::size_t faces)
      : wraps(patch.v_low == End::wrap), low_pole(patch.v_low == End::pole), high_pole(patch.v_high == End::pole) {
    const double wanted = static_cast<double>(faces);
    columns = std::max<Index>(3, static_cast<Index>(std::lround(std::sqrt(wanted * patch.aspect / 2))));
    const double triangle_rows = wanted / columns + low_pole + high_pole;
    rows = std::max<Index>(wraps ? 3 : 2, static_cast<Index>(std::lround(triangle_rows / 2)));
    row_length = patch.u_wraps ? columns : columns + 1;
  }

  Index first_ring() const { return low_pole ? 1 : 0; }
  Index ring_end() const { return wraps || high_pole ? rows : rows + 1; }
  /// The vertex in a column (from 0 to `columns`) of a row (from 0 to `rows`).
  Index vertex(Index column, Index row) const {
    if (low_pole && row == 0) return 0;
    const Index ring = (wraps ? row % rows : row) - first_ring();
    const Index first = low_pole ? 1 : 0;
    if (high_pole && row == rows) return first + ring * row_length;
    return first + ring * row_length + column % row_length;
  }
};

double mean_edge(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h)
    sum += distance(mesh.positions()[mesh.from(h)], mesh.positions()[mesh.to(h)]);
  return sum / (3.0 * static_cast<double>(mesh.face_count()));
}

/// The mesh with vertex i at radius(i, direction) from the origin; the mesh's vertices are unit vectors.
template <class Radius>
SurfaceMesh with_radius(const SurfaceMesh& sphere, Radius radius) {
  std::vector<Vec3> positions(sphere.positions().begin(), sphere.positions().end());
  for (Vec3& p : positions) p = radius(p) * p;
  return SurfaceMesh(std::move(positions), {sphere.triangles().begin(), sphere.triangles().end()});
}

/// The middle of an edge, pushed out to the unit sphere.
Vec3 middle_on_sphere(const Vec3& p, const Vec3& q) {
  const Vec3 sum = p + q;
  return sum / norm(sum);
}

}  // namespace

SurfaceMesh patch_mesh(const Patch& patch, std::size_t faces, Random* jitter) {
  const Layout layout(patch, faces);
  std::vector<Vec3> positions;
  if (layout.low_pole) positions.push_back(patch.at(0, 0).position);
  for (Index row = layout.first_ring(); row < layout.ring_end(); ++row)
    for (Index column = 0; column < layout.row_length; ++column) {
      const double du = jitter ? jitter->uniform(-0.3, 0.3) : 0, dv = jitter ? jitter->uniform(-0.3, 0.3) : 0;
      positions.push_back(patch.at((column + du) / layout.columns, (row + dv) / layout.rows).position);
    }
  if (layout.high_pole) positions.push_back(patch.at(0, 1).position);

  std::vector<Triangle> triangles;
  for (Index row = 0; row < layout.rows; ++row)
    for (Index column = 0; column < layout.columns; ++column) {
      const Index a = layout.vertex(column, row), b = layout.vertex(column + 1, row);
      const Index c = layout.vertex(column + 1, row + 1), d = layout.vertex(column, row + 1);
      if (a == b)
        triangles.push_back({a, c, d});
      else if (c == d)
        triangles.push_back({a, b, c});
      else
        split_quad(positions, a, b, c, d, triangles);
    }
  return SurfaceMesh(std::move(positions), std::move(triangles));
}

SurfaceMesh icosphere(std::size_t faces) {
  constexpr double g = std::numbers::phi;
  std::vector<Vec3> positions{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : positions) p = p / norm(p);
  std::vector<Triangle> triangles{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  // A factor 4 between counts: the next one is nearer by ratio when less than half of the wanted count is there.
  while (2 * triangles.size() < faces) quarter(positions, triangles, middle_on_sphere);
  return SurfaceMesh(std::move(positions), std::move(triangles));
}

SurfaceMesh noisy_sphere(std::size_t faces, Random& random) {
  const SurfaceMesh sphere = icosphere(faces);
  const double reach = 0.5 * mean_edge(sphere);
  return with_radius(sphere, [&](const Vec3&) { return 1 + reach * random.uniform(-1, 1); });
}

SurfaceMesh radial_mesh(const Radial& body, std::size_t faces) {
  return with_radius(icosphere(faces), [&](const Vec3& p) { return body.radius(p).value; });
}

double area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    sum += 0.5 * norm(cross(q - p, r - p));
  }
  return sum;
}

}  // namespace geodrome::shapes
