// SPDX-License-Identifier: MIT
#include "plugins/reconstructor_stars/star_union.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "plugins/common/points/cell_radius.hpp"
#include "plugins/reconstructor_stars/union_faults.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

constexpr auto automatic = BoundaryRule::automatic;

std::vector<Triangle> faces_of(const MeshPtr& mesh) { return {mesh->triangles().begin(), mesh->triangles().end()}; }

std::vector<Vec3> points_of(const MeshPtr& mesh) { return {mesh->positions().begin(), mesh->positions().end()}; }

const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Without a way to tell inside from outside: each face as its corners ascend.
std::vector<Triangle> tetrahedron(Index a, Index b, Index c, Index d) {
  return {{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}};
}

TEST(UnionFaults, TurnsFacesOutwards) {
  std::vector<Triangle> faces = tetrahedron(0, 1, 2, 3);
  EXPECT_FALSE(orient_or_fault(faces, corners, BoundaryRule::closed));
  for (const auto& [a, b, c] : faces) {
    const Vec3 front = cross(corners[b] - corners[a], corners[c] - corners[a]);
    EXPECT_GT(dot(front, corners[a] - Vec3{0.1, 0.1, 0.1}), 0);
  }
}

TEST(UnionFaults, NamesTheEndsOfAnEdgeOfThreeFaces) {
  std::vector<Triangle> faces{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const std::vector<Vec3> points(5);
  const auto fault = orient_or_fault(faces, points, automatic);
  ASSERT_TRUE(fault);
  EXPECT_STREQ(fault->code, "crowded_edges");
  EXPECT_EQ(fault->count, 1u);
  EXPECT_EQ(fault->places, (std::vector<Index>{0, 1}));
}

TEST(UnionFaults, NamesThePointWhereTwoFansMeet) {
  std::vector<Triangle> faces = tetrahedron(0, 1, 2, 3);
  for (const Triangle& t : tetrahedron(3, 4, 5, 6)) faces.push_back(t);
  const std::vector<Vec3> points(7);
  const auto fault = orient_or_fault(faces, points, automatic);
  ASSERT_TRUE(fault);
  EXPECT_STREQ(fault->code, "split_points");
  EXPECT_EQ(fault->places, std::vector<Index>{3});
}

TEST(UnionFaults, NamesWhereAMoebiusStripCannotBeOriented) {
  const MeshPtr strip = test::moebius(30);
  std::vector<Triangle> faces = faces_of(strip);
  const auto fault = orient_or_fault(faces, points_of(strip), automatic);
  ASSERT_TRUE(fault);
  EXPECT_STREQ(fault->code, "not_orientable");
  EXPECT_EQ(fault->count, 1u) << "cut once across, the strip has two sides";
  EXPECT_EQ(fault->places.size(), 2u);
}

TEST(UnionFaults, CallsASmallLoopAThinPlaceUnlessHolesAreExpected) {
  std::vector<Triangle> faces = tetrahedron(0, 1, 2, 3);
  faces.pop_back();
  const auto fault = orient_or_fault(faces, corners, automatic);
  ASSERT_TRUE(fault);
  EXPECT_STREQ(fault->code, "thin_places");
  EXPECT_EQ(fault->count, 1u);
  EXPECT_EQ(fault->places, (std::vector<Index>{1, 2, 3}));
  EXPECT_FALSE(orient_or_fault(faces, corners, BoundaryRule::open));
}

TEST(UnionFaults, CallsALoopOfTwentyPointsAHole) {
  for (const Index around : {Index{19}, Index{20}}) {
    std::vector<Triangle> fan;
    for (Index i = 0; i < around; ++i) fan.push_back({around, i, (i + 1) % around});
    EXPECT_EQ(orient_or_fault(fan, std::vector<Vec3>(around + 1), automatic).has_value(), around < 20) << around;
  }
}

TEST(UnionFaults, NamesWorstPlacesFirst) {
  EXPECT_EQ(worst_first({5, 2, 9, 2, 9, 9}), (std::vector<Index>{9, 2, 5}));
  EXPECT_TRUE(worst_first({}).empty());
}

/// The union by counting over the rings of all stars.
TEST(StarUnion, HasEveryTriangleOfEveryStarOnceAndCountsWhoHasIt) {
  const PointSample sample = test::torus(600, 3);
  std::vector<Vec3> normals;
  for (const Vec3& p : sample.points) {
    const double ring = std::hypot(p.x, p.y);
    normals.push_back(Vec3{p.x - p.x / ring, p.y - p.y / ring, p.z} / 0.4);
  }
  QuietContext context;
  const Neighbours neighbours(sample.points);
  const PlanarStars stars(neighbours, normals, sample_reach(sample.points), context, {});
  const std::vector<double> everywhere(sample.size(), std::numeric_limits<double>::infinity());
  const StarUnion all = union_of(stars, sample.points, everywhere);

  std::map<std::set<Index>, std::set<Index>> owners;
  for (Index s = 0; s < stars.size(); ++s)
    for (std::size_t i = 0; i < stars(s).size(); ++i)
      if (stars(s)[i].real)
        owners[{s, stars(s)[(i + stars(s).size() - 1) % stars(s).size()].site, stars(s)[i].site}].insert(s);
  ASSERT_EQ(all.faces.size(), owners.size());
  std::set<Index> disputed(all.disputed.begin(), all.disputed.end());
  for (Index f = 0; f < all.faces.size(); ++f) {
    const auto found = owners.find({all.faces[f].begin(), all.faces[f].end()});
    ASSERT_NE(found, owners.end());
    EXPECT_EQ(disputed.count(f) == 1, found->second.size() < 3);
  }
  EXPECT_GT(disputed.size(), 0u);
  EXPECT_LT(disputed.size(), all.faces.size());

  EXPECT_TRUE(union_of(stars, sample.points, std::vector<double>(sample.size(), 0)).faces.empty());
}

}  // namespace
}  // namespace geodrome
