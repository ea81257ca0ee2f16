// SPDX-License-Identifier: MIT
#include "plugins/common/points/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "geodrome/errors.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

/// Every point but `without`, by distance and index.
std::vector<Neighbour> all_sorted(const std::vector<Vec3>& points, const Vec3& query, Index without) {
  std::vector<Neighbour> all;
  for (Index i = 0; i < points.size(); ++i)
    if (i != without) all.push_back({squared_distance(query, points[i]), i});
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<PointSample> samples() {
  return {test::torus(700, 1, 10), test::plane_lattice(20, 30), test::cube(500, 2),
          test::moved(test::plane_lattice(25, 25), 1e-6, {0, 0, 0}),
          test::moved(test::torus(600, 3), 1e6, {1e6, -1e6, 1e6})};
}

TEST(Neighbours, NearestEqualsTheSortedListWithTiesByIndex) {
  for (const PointSample& sample : samples()) {
    const Neighbours neighbours(sample.points);
    std::vector<Neighbour> found;
    test::Random random(4);
    for (int trial = 0; trial < 60; ++trial) {
      const Index i = static_cast<Index>(random.below(sample.size()));
      const std::size_t k = 1 + random.below(40);
      std::vector<Neighbour> expected = all_sorted(sample.points, sample.points[i], i);
      expected.resize(k);
      neighbours.nearest(sample.points[i], k, found, i);
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(Neighbours, QueriesFarFromAllPointsAreExact) {
  const PointSample sample = test::plane_lattice(20, 20);
  const Neighbours neighbours(sample.points);
  std::vector<Neighbour> found;
  test::Random random(5);
  for (int trial = 0; trial < 60; ++trial) {
    const Vec3 query = random.uniform(0, 1000) * random.direction();
    std::vector<Neighbour> expected = all_sorted(sample.points, query, no_index);
    expected.resize(7);
    neighbours.nearest(query, 7, found);
    ASSERT_EQ(found, expected);
  }
}

TEST(Neighbours, BallIsClosedAndComplete) {
  for (const PointSample& sample : samples()) {
    const Neighbours neighbours(sample.points);
    std::vector<Neighbour> found;
    test::Random random(6);
    for (int trial = 0; trial < 60; ++trial) {
      const Index i = static_cast<Index>(random.below(sample.size()));
      std::vector<Neighbour> expected = all_sorted(sample.points, sample.points[i], no_index);
      // A radius at which a point lies exactly on the sphere.
      const double radius = distance(sample.points[i], sample.points[expected[random.below(30)].index]);
      std::erase_if(expected,
                    [&](const Neighbour& n) { return distance(sample.points[i], sample.points[n.index]) > radius; });
      neighbours.within(sample.points[i], radius, found);
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(Neighbours, TiesAtTheLastPlaceAreAllTaken) {
  const PointSample sample = test::plane_lattice(9, 9);
  const Neighbours neighbours(sample.points);
  std::vector<Neighbour> found;
  neighbours.nearest_and_ties(sample.points[40], 3, found, 40);
  EXPECT_EQ(found.size(), 4U);
  neighbours.nearest_and_ties(sample.points[40], 5, found, 40);
  EXPECT_EQ(found.size(), 8U);
}

TEST(Neighbours, AskingForMoreThanThereAreGivesAll) {
  const Neighbours neighbours(test::cube(5, 1).points);
  std::vector<Neighbour> found;
  neighbours.nearest({0, 0, 0}, 10, found);
  EXPECT_EQ(found.size(), 5U);
}

TEST(Neighbours, NoPointsGiveNoNeighbours) {
  const Neighbours neighbours{{}};
  std::vector<Neighbour> found{{0, 1}};
  neighbours.nearest({0, 0, 0}, 3, found);
  EXPECT_TRUE(found.empty());
  neighbours.within({0, 0, 0}, 3, found);
  EXPECT_TRUE(found.empty());
}

TEST(Neighbours, ManyPointsAtOnePlaceAreAllFound) {
  const Neighbours neighbours(std::vector<Vec3>(100, Vec3{1, 2, 3}));
  std::vector<Neighbour> found;
  neighbours.nearest({1, 2, 3}, 200, found, 7);
  EXPECT_EQ(found.size(), 99U);
}

TEST(Neighbours, APointThatIsNotFiniteIsNamed) {
  std::vector<Vec3> points = test::cube(5, 1).points;
  points[3].y = std::numeric_limits<double>::quiet_NaN();
  try {
    const Neighbours neighbours(points);
    FAIL();
  } catch (const SampleError& error) {
    EXPECT_NE(std::string(error.what()).find("point 3"), std::string::npos);
  }
}

}  // namespace
}  // namespace geodrome
