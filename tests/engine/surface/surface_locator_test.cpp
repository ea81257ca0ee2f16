// SPDX-License-Identifier: MIT
#include "geodrome/engine/surface_locator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geodrome/detail/point_triangle.hpp"

namespace geodrome {
namespace {

using detail::closest_on_triangle, detail::TrianglePoint;

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
Vec3 random_point(std::mt19937_64& random) { return {uniform(random), uniform(random), uniform(random)}; }

/// Triangles that have nothing to do with each other: of any size, crossing.
MeshPtr soup(Index faces, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (Index f = 0; f < faces; ++f) {
    const Vec3 centre = random_point(random);
    const double size = std::pow(0.01, uniform(random));
    for (int i = 0; i < 3; ++i) positions.push_back(centre + size * random_point(random));
    triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  return std::make_shared<SurfaceMesh>(positions, triangles);
}

/// n x n squares of side 1, each cut in two, with heights in [0, height].
MeshPtr terrain(Index n, double height, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j)
      positions.push_back({static_cast<double>(i), static_cast<double>(j), height * uniform(random)});
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + 1, c = a + n + 1, d = c + 1;
      triangles.push_back({a, c, d});
      triangles.push_back({a, d, b});
    }
  return std::make_shared<SurfaceMesh>(positions, triangles);
}

/// Every face in turn; the lowest of the closest.
ClosestPoint by_brute_force(const SurfaceMesh& mesh, const Vec3& query) {
  ClosestPoint best{{}, std::numeric_limits<double>::infinity()};
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const TrianglePoint point = closest_on_triangle(query, mesh.corners(face));
    if (const double d = std::sqrt(point.squared_distance); d < best.distance) best = {{face, point.b}, d};
  }
  return best;
}

TEST(SurfaceLocator, AgreesWithBruteForceOnCrossingTriangles) {
  const MeshPtr mesh = soup(500, 1);
  const SurfaceLocator locator(mesh);
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 query = 4 * random_point(random) - Vec3{1, 1, 1};
    const ClosestPoint found = locator.closest(query), expected = by_brute_force(*mesh, query);
    EXPECT_EQ(found.at, expected.at) << i;
    EXPECT_EQ(found.distance, expected.distance) << i;
  }
}

TEST(SurfaceLocator, AgreesWithBruteForceOnTerrain) {
  const MeshPtr mesh = terrain(20, 3, 3);
  const SurfaceLocator locator(mesh);
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 query = 24 * random_point(random) - Vec3{2, 2, 2};
    EXPECT_EQ(locator.closest(query).distance, by_brute_force(*mesh, query).distance) << i;
  }
}

TEST(SurfaceLocator, GivesTiesToTheLowestFace) {
  // Flat, with queries straight above the vertices: up to six faces are equally close.
  const MeshPtr mesh = terrain(12, 0, 5);
  const SurfaceLocator locator(mesh);
  for (const Vec3& vertex : mesh->positions()) {
    const Vec3 query = vertex + Vec3{0, 0, 2};
    EXPECT_EQ(locator.closest(query).at.face, by_brute_force(*mesh, query).at.face);
  }
}

TEST(SurfaceLocator, FindsVerticesExactly) {
  const MeshPtr mesh = terrain(15, 2, 6);
  const SurfaceLocator locator(mesh);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const ClosestPoint found = locator.closest(mesh->positions()[v]);
    EXPECT_EQ(found.at, mesh->at_vertex(v)) << v;
    EXPECT_EQ(found.distance, 0) << v;
  }
}

TEST(SurfaceLocator, PrefersTheVertexWhereALowerFacePassesThroughIt) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 0, 1}, {1, -1, 0}};
  const auto mesh = std::make_shared<SurfaceMesh>(positions, std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(mesh->vertex_at(SurfaceLocator(mesh).closest({1, 0, 0}).at), 3u);
}

TEST(SurfaceLocator, FindsThePointBelowAFlatSurface) {
  const ClosestPoint found = SurfaceLocator(terrain(4, 0, 7)).closest({1.25, 2.5, -3});
  EXPECT_DOUBLE_EQ(found.distance, 3);
}

TEST(SurfaceLocator, StaysExactFarFromTheOrigin) {
  std::vector<Vec3> positions;
  const MeshPtr near = terrain(10, 1, 8);
  for (const Vec3& p : near->positions()) positions.push_back(p + Vec3{1e9, -1e9, 1e9});
  const auto mesh = std::make_shared<SurfaceMesh>(
      positions, std::vector<Triangle>(near->triangles().begin(), near->triangles().end()));
  const SurfaceLocator locator(mesh);
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_EQ(mesh->vertex_at(locator.closest(positions[v]).at), v);
}

TEST(SurfaceLocator, WorksOnDegenerateTrianglesAlone) {
  const auto mesh = std::make_shared<SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                                  std::vector<Triangle>{{0, 1, 2}});
  EXPECT_DOUBLE_EQ(SurfaceLocator(mesh).closest({0.5, 1, 0}).distance, 1);
}

TEST(SurfaceLocator, RefusesAMeshWithoutFaces) {
  const auto mesh = std::make_shared<SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}}, std::vector<Triangle>{});
  EXPECT_THROW(SurfaceLocator{mesh}, InputError);
}

TEST(SurfaceLocator, RefusesAQueryThatIsNotFinite) {
  const SurfaceLocator locator(terrain(2, 1, 9));
  EXPECT_THROW(locator.closest({0, std::nan(""), 0}), InputError);
}

}  // namespace
}  // namespace geodrome
