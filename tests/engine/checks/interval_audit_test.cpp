// SPDX-License-Identifier: MIT
#include "engine/checks/interval_audit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

/// A square of 8 x 8 cells in the plane, where the distance from the first corner is the straight line.
class Intervals : public ::testing::Test {
 protected:
  Intervals() {
    for (const Vec3& p : mesh_->positions()) distances_.push_back(distance(mesh_->positions()[0], p));
    bounds_ = distances_;
  }
  IntervalFigures audited(const IntervalTerms& terms = {1.1, true}) const {
    return audit_intervals(*mesh_, distances_, bounds_, terms);
  }
  void scale(std::vector<double>& values, double factor) const {
    for (double& value : values) value *= factor;
  }

  const MeshPtr mesh_ = plane_grid(8);
  std::vector<double> distances_, bounds_;
  static constexpr Index somewhere_ = 40;
};

TEST_F(Intervals, OfExactDistancesAreEmptyAndHold) {
  const IntervalFigures figures = audited({1, true});
  EXPECT_EQ(figures.vertices, mesh_->vertex_count());
  EXPECT_EQ(figures.largest, 0);
  EXPECT_EQ(figures.mean(), 0);
  EXPECT_TRUE(figures.hold()) << figures.worst;
}

TEST_F(Intervals, AreMeasuredByTheirLowerEnd) {
  scale(distances_, 1.05);
  distances_[somewhere_] = 1.08 * bounds_[somewhere_];
  const IntervalFigures figures = audited();
  EXPECT_TRUE(figures.hold());
  EXPECT_NEAR(figures.largest, 0.08, 1e-12);
  const double others = static_cast<double>(mesh_->vertex_count() - 2);  // the source has none
  EXPECT_NEAR(figures.sum, 0.05 * others + 0.08, 1e-12);
}

TEST_F(Intervals, AreInfiniteWhereOnlyTheBoundIsZero) {
  bounds_[somewhere_] = 0;
  EXPECT_EQ(audited({infinity, true}).largest, infinity);
}

TEST_F(Intervals, MissWhereTheBoundIsAboveTheDistance) {
  bounds_[somewhere_] *= 1.0001;
  const IntervalFigures figures = audited();
  EXPECT_FALSE(figures.hold());
  EXPECT_EQ(figures.worst_vertex, somewhere_);
  EXPECT_NEAR(figures.worst * figures.scale, 0.0001 * distances_[somewhere_], 1e-12);
}

TEST_F(Intervals, MissWhereTheFactorIsExceeded) {
  distances_[somewhere_] *= 1.11;
  EXPECT_FALSE(audited().hold());
  EXPECT_TRUE(audited({infinity, true}).hold()) << "no factor is promised";
}

/// A wave that is lost makes a whole region too far, distances and bounds alike: their rim gives them away.
TEST_F(Intervals, MissWhereABoundIsSteeperThanAnEdgeAllows) {
  for (Index v = somewhere_; v < mesh_->vertex_count(); ++v) distances_[v] *= 1.5, bounds_[v] *= 1.5;
  EXPECT_FALSE(audited({1, true}).hold());
}

TEST_F(Intervals, MissWhereANeighbourOfAReachedVertexIsUnreachable) {
  distances_[somewhere_] = bounds_[somewhere_] = infinity;
  EXPECT_EQ(audited().worst, infinity);
}

TEST_F(Intervals, MayEndAtALimit) {
  for (Index v = 0; v < mesh_->vertex_count(); ++v)
    if (distances_[v] > 4) distances_[v] = infinity, bounds_[v] = 4;
  const IntervalFigures figures = audited({1, true});
  EXPECT_TRUE(figures.hold());
  EXPECT_LT(figures.vertices, mesh_->vertex_count());
}

TEST_F(Intervals, WithoutNumbersMiss) {
  bounds_[somewhere_] = NAN;
  EXPECT_EQ(audited().worst, infinity);
  bounds_[somewhere_] = -1;
  EXPECT_GE(audited({infinity, true}).worst * audited().scale, 1);
}

/// The middle of an interval may be too short: a vertex with a narrow interval beside one with a wide one that lies
/// lower is a contradiction only for upper ends.
TEST_F(Intervals, OfMiddlesReachAsFarAboveAsBelow) {
  distances_[0] = 0;
  for (const Index v : {somewhere_}) bounds_[v] = distances_[v] + 0.5, distances_[v] = bounds_[v];
  for (Index v = 0; v < mesh_->vertex_count(); ++v)
    if (v != somewhere_) bounds_[v] = 0.4 * distances_[v];
  EXPECT_TRUE(audited({infinity, false}).hold());
  for (Index v = 0; v < mesh_->vertex_count(); ++v)
    if (v != somewhere_) distances_[v] *= 0.8;
  EXPECT_FALSE(audited({infinity, true}).hold());
}

TEST_F(Intervals, OnWeightedFacesAreHeldToWeightedEdges) {
  const SurfaceMesh heavy({mesh_->positions().begin(), mesh_->positions().end()},
                          {mesh_->triangles().begin(), mesh_->triangles().end()},
                          std::vector<double>(mesh_->face_count(), 3.0));
  scale(distances_, 3), scale(bounds_, 3);
  EXPECT_FALSE(audited().hold()) << "three times as far as the plain edges allow";
  EXPECT_TRUE(audit_intervals(heavy, distances_, bounds_, {1, true}).hold());
}

TEST(IntervalFigures, AddUpAndKeepTheWorstRow) {
  IntervalFigures sum;
  sum.add({.vertices = 2, .largest = 0.1, .sum = 0.15, .scale = 3, .worst = 0, .worst_vertex = no_index}, 0);
  sum.add({.vertices = 1, .largest = 0.3, .sum = 0.3, .scale = 2, .worst = 0.5, .worst_vertex = 7}, 1);
  sum.add({.vertices = 1, .largest = 0.2, .sum = 0.15, .scale = 5, .worst = 0.4, .worst_vertex = 8}, 2);
  EXPECT_EQ(sum.vertices, 4u);
  EXPECT_EQ(sum.largest, 0.3);
  EXPECT_DOUBLE_EQ(sum.mean(), 0.15);
  EXPECT_EQ(sum.scale, 5);
  EXPECT_EQ(sum.worst_row, 1u);
  EXPECT_EQ(sum.worst_vertex, 7u);
}

}  // namespace
}  // namespace geodrome::test
