// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "plugins/common/points/cell_radius.hpp"
#include "plugins/common/surfaces/face_deletion.hpp"
#include "plugins/reconstructor_delaunay_cut/feature_size.hpp"
#include "plugins/reconstructor_delaunay_cut/manifold_repair.hpp"
#include "plugins/reconstructor_delaunay_cut/orient_normals.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

using test::Random;

Tetrahedra cells_of_cube(std::size_t n, std::uint64_t seed) { return delaunay_tetrahedra(test::cube(n, seed).points); }

CutCosts random_costs(const Tetrahedra& t, std::uint64_t seed) {
  Random random(seed);
  CutCosts costs;
  costs.inside.resize(t.size(), 0);
  costs.cut.resize(t.size());
  for (Index c = 0; c < t.size(); ++c) {
    if (!t.infinite(c)) costs.inside[c] = static_cast<std::int32_t>(random.below(20001)) - 10000;
    for (int i = 0; i < 4; ++i)
      costs.cut[c][i] = t.neighbours[c][i] < c ? costs.cut[t.neighbours[c][i]][t.mirror(c, i)]
                                               : static_cast<std::uint16_t>(random.below(4001));
  }
  return costs;
}

std::int64_t cost_of(const Tetrahedra& t, const CutCosts& costs, const Labels& inside) {
  std::int64_t sum = 0;
  for (Index c = 0; c < t.size(); ++c) {
    if (!inside[c]) continue;
    sum += costs.inside[c];
    for (int i = 0; i < 4; ++i) sum += inside[t.neighbours[c][i]] ? 0 : costs.cut[c][i];
  }
  return sum;
}

std::vector<Triangle> border(const Tetrahedra& t, const Labels& inside) {
  std::vector<Triangle> faces;
  for (Index c = 0; c < t.size(); ++c)
    for (int i = 0; i < 4; ++i)
      if (inside[c] && !inside[t.neighbours[c][i]]) faces.push_back(facet_of(t.corners[c], i));
  return faces;
}

TEST(Tetrahedra, FillTheConvexHullAndLookOutwards) {
  const std::vector<Vec3> points = test::cube(60, 1).points;
  const Tetrahedra t = delaunay_tetrahedra(points);
  Labels inside(t.size());
  double sum = 0;
  for (Index c = 0; c < t.size(); ++c) {
    inside[c] = !t.infinite(c);
    if (t.infinite(c)) continue;
    const auto& [p, q, r, s] = t.corners[c];
    const double volume = dot(points[q] - points[p], cross(points[r] - points[p], points[s] - points[p])) / 6;
    EXPECT_GT(volume, 0);
    sum += volume;
  }
  double hull = 0;
  for (const auto& [p, q, r] : border(t, inside)) hull += dot(points[p], cross(points[q], points[r])) / 6;
  EXPECT_NEAR(hull, sum, 1e-12);
}

TEST(Tetrahedra, NeighboursShareTheirFacet) {
  const Tetrahedra t = cells_of_cube(80, 2);
  for (Index c = 0; c < t.size(); ++c)
    for (int i = 0; i < 4; ++i) {
      const Index other = t.neighbours[c][i];
      EXPECT_EQ(t.neighbours[other][t.mirror(c, i)], c);
      EXPECT_EQ(std::ranges::count(t.corners[c], t.corners[other][t.mirror(c, i)]), 0);
    }
}

TEST(Tetrahedra, OfALatticeDoNotDependOnTheOrderOfInsertion) {
  PointSample lattice;
  for (int i = 0; i < 64; ++i)
    lattice.points.push_back({static_cast<double>(i % 4), static_cast<double>(i / 4 % 4), static_cast<double>(i / 16)});
  const std::vector<Index> order = test::permutation(64, 3);
  const auto named = [](const Tetrahedra& t, const std::vector<Index>& name) {
    std::set<std::set<Index>> cells;
    for (const auto& corners : t.corners) {
      std::set<Index> cell;
      for (const Index p : corners) cell.insert(p == no_index || name.empty() ? p : name[p]);
      cells.insert(cell);
    }
    return cells;
  };
  EXPECT_EQ(named(delaunay_tetrahedra(lattice.points), {}),
            named(delaunay_tetrahedra(test::permuted(lattice, order).points), order));
}

TEST(Labelling, IsTheCheapestOfAll) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Tetrahedra t = cells_of_cube(6, seed);
    const CutCosts costs = random_costs(t, seed);
    std::vector<Index> finite;
    for (Index c = 0; c < t.size(); ++c)
      if (!t.infinite(c)) finite.push_back(c);
    ASSERT_LE(finite.size(), 16u);
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    for (std::uint32_t choice = 0; choice < (1u << finite.size()); ++choice) {
      Labels inside(t.size(), 0);
      for (std::size_t k = 0; k < finite.size(); ++k) inside[finite[k]] = choice >> k & 1;
      best = std::min(best, cost_of(t, costs, inside));
    }
    EXPECT_EQ(cost_of(t, costs, cheapest_labels(t, costs)), best) << "seed " << seed;
  }
}

TEST(ManifoldRepair, MakesTheBorderOfRandomLabelsAManifold) {
  std::size_t repaired = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Tetrahedra t = cells_of_cube(40, seed);
    const CutCosts costs = random_costs(t, seed);
    Random random(seed);
    Labels inside(t.size(), 0);
    for (Index c = 0; c < t.size(); ++c) inside[c] = !t.infinite(c) && random.uniform() < 0.5;
    const RepairRecord record = make_manifold(t, costs, CellsOfPoint(t, 40), 40, inside);
    EXPECT_GT(record.flips, 0u);
    if (!record.unresolved.empty()) continue;
    ++repaired;
    const detail::Connectivity c = detail::connect(border(t, inside), 40);
    EXPECT_TRUE(c.manifold && c.closed && c.oriented) << "seed " << seed;
    for (Index k = 0; k < t.size(); ++k) EXPECT_FALSE(t.infinite(k) && inside[k]);
  }
  EXPECT_GT(repaired, 15u) << "too few to mean anything";
}

TEST(ManifoldRepair, LeavesAManifoldAlone) {
  const Tetrahedra t = cells_of_cube(50, 4);
  Labels inside(t.size());
  for (Index c = 0; c < t.size(); ++c) inside[c] = !t.infinite(c);
  const Labels before = inside;
  EXPECT_EQ(make_manifold(t, random_costs(t, 1), CellsOfPoint(t, 50), 50, inside).flips, 0u);
  EXPECT_EQ(inside, before);
}

struct Signs {
  std::vector<Vec3> points, truth, given;
};

/// Normals of an ellipsoid with half-axes 3, 2 and `thickness`, with random signs.
Signs ellipsoid(std::size_t n, double thickness) {
  Random random(9);
  Signs s;
  for (const Vec3& p : test::sphere(n, 7).points) {
    s.points.push_back({3 * p.x, 2 * p.y, thickness * p.z});
    const Vec3 normal{p.x / 3, p.y / 2, p.z / thickness};
    s.truth.push_back(normal / norm(normal));
    s.given.push_back(random.uniform() < 0.5 ? -s.truth.back() : s.truth.back());
  }
  return s;
}

TEST(OrientNormals, LooksOutwardsOnEllipsoidsThickAndThin) {
  for (const double thickness : {1.0, 0.2}) {
    const Signs s = ellipsoid(4000, thickness);
    const Neighbours neighbours(s.points);
    QuietContext context;
    const PlanarStars stars(neighbours, s.given, sample_reach(s.points), context, {});
    const OrientedSample oriented = orient(stars, s.points, s.given, std::vector<double>(s.points.size(), 0.3), 4.96);
    ASSERT_EQ(oriented.pieces.size(), 1u);
    for (std::size_t i = 0; i < s.points.size(); ++i)
      ASSERT_GT(dot(oriented.normals[i], s.truth[i]), 0) << "thickness " << thickness << ", point " << i;
  }
}

TEST(FeatureSizes, OfATorusAreTheRadiusOfItsTube) {
  PointSample sample = test::torus(4000, 3);
  OrientedPiece piece;
  piece.points = sample.points;
  const Tetrahedra t = delaunay_tetrahedra(piece.points);
  Labels inside(t.size(), 0);
  for (Index c = 0; c < t.size(); ++c) {
    if (t.infinite(c)) continue;
    Vec3 centre;
    for (const Index p : t.corners[c]) centre = centre + piece.points[p] / 4;
    inside[c] = std::hypot(std::hypot(centre.x, centre.y) - 1, centre.z) < 0.37;
  }
  const std::vector<double> sizes = feature_sizes(t, CellsOfPoint(t, sample.size()), inside, piece);
  for (const double size : sizes) {
    ASSERT_GT(size, 0.36) << "a pole that is none: the surface would seem to be sampled too sparsely";
    ASSERT_LT(size, 0.44);
  }
}

TEST(WithoutFaces, KeepsTheLargestFanWhereFacesPart) {
  // A fan of six triangles around vertex 0; without the second and the fifth, two and two are left: the lower stays.
  std::vector<Triangle> faces;
  for (Index i = 0; i < 6; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
  const std::vector<Index> doomed{1, 4};
  EXPECT_EQ(without_faces(faces, doomed, 7), (std::vector<Triangle>{faces[0], faces[5]}));
  const std::vector<Index> uneven{0, 2};
  EXPECT_EQ(without_faces(faces, uneven, 7), (std::vector<Triangle>{faces[3], faces[4], faces[5]}));
}

}  // namespace
}  // namespace geodrome
