// SPDX-License-Identifier: MIT
// Which points of a sample look like one surface, and the part of a surface that the sample shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/surface/part_surface.hpp"
#include "engine/surface/sample_chain.hpp"
#include "engine/surface/sample_part.hpp"
#include "tests/support/scans.hpp"

namespace geodrome::test {
namespace {

class SurfaceParts : public ::testing::Test {
 protected:
  SurfaceParts() { settings_.threads = 1, settings_.stages.reconstructor = "advancing_front"; }

  SurfaceAttempt attempt(const Input& input) {
    return SampleChain(input, host_, settings_, observer_).make(settings_.stages);
  }
  /// The largest candidate.
  std::vector<Index> candidate(const PointSample& sample) {
    const Input input = make_input({.positions = sample.points});
    const auto parts = part_candidates(*attempt(input).surface.sample, observer_);
    return parts.empty() ? std::vector<Index>{} : parts.front();
  }
  static std::size_t below(const std::vector<Index>& part, Index end) {
    return static_cast<std::size_t>(std::ranges::count_if(part, [&](Index i) { return i < end; }));
  }

  RunSettings settings_;
  PluginHost host_;
  Observer observer_;
};

TEST_F(SurfaceParts, AreNotFoundInACube) { EXPECT_TRUE(candidate(cube(5000, 3)).empty()); }

TEST_F(SurfaceParts, OfASphereAmongOutliersAreTheSphere) {
  constexpr Index on_sphere = 3000;
  PointSample sample = sphere(on_sphere, 1);
  add_outliers(sample, 300, 1.5, 2);
  const std::vector<Index> part = candidate(sample);
  EXPECT_GE(below(part, on_sphere), 0.99 * on_sphere);
  for (const Index i : part) EXPECT_NEAR(norm(sample.points[i]), 1, 0.03) << "half a spacing";
}

TEST_F(SurfaceParts, DoNotEndWhereTheDensityChangesByTen) {
  const PointSample sample = graded_plane(4000, 10, 5);
  EXPECT_GE(candidate(sample).size(), 0.97 * 4000);
}

TEST_F(SurfaceParts, EndWhereADepthCameraJumps) {
  const DepthImage image = depth_image(80, 7);
  const std::vector<Index> part = candidate({image.points});
  ASSERT_FALSE(part.empty());
  const DepthImage::Kind kind = image.kind[part.front()];
  EXPECT_NE(kind, DepthImage::flying);
  const double depth = kind == DepthImage::near_plane ? 1 : 2;
  for (const Index i : part) EXPECT_NEAR(image.points[i].z, depth, depth / 79) << "a spacing off: point " << i;
  EXPECT_GE(part.size(), 0.85 * static_cast<double>(std::ranges::count(image.kind, kind)));
}

TEST_F(SurfaceParts, OfAWholeSurfaceAreTheSurfaceItself) {
  const Input input = make_input({.positions = sphere(1000, 4).points});
  PlacedSurface surface = attempt(input).surface;
  const MeshPtr mesh = surface.mesh;
  ASSERT_TRUE(cut_to_part(input, surface));
  EXPECT_EQ(surface.mesh, mesh);
  EXPECT_NE(surface.inserter, nullptr);
  EXPECT_EQ(surface.part->points, 1000u);
  EXPECT_EQ(surface.part->share(), 1);
  EXPECT_EQ(surface.part->faces_left_out, 0u);
}

TEST_F(SurfaceParts, LeaveHolesOfTheSampleOpen) {
  const PointSample sample = plane_with_hole(6000, 0.12, 3);
  const Input input = make_input({.positions = sample.points});
  SurfaceAttempt made = attempt(input);
  // Two faces over the hole, as a reconstructor may make them.
  std::vector<Triangle> faces(made.surface.mesh->triangles().begin(), made.surface.mesh->triangles().end());
  const auto nearest = [&](const Vec3& p) {
    const auto positions = made.surface.mesh->positions();
    return static_cast<Index>(std::ranges::min_element(positions, {}, [&](const Vec3& q) { return distance(p, q); }) -
                              positions.begin());
  };
  const Index east = nearest({0.12, 0, 0}), north = nearest({0, 0.12, 0}), west = nearest({-0.12, 0, 0});
  const auto positions = made.surface.mesh->positions();
  faces.push_back({east, north, west});
  made.surface.mesh = std::make_shared<const SurfaceMesh>(std::vector(positions.begin(), positions.end()), faces);
  made.surface.locator = std::make_shared<const SurfaceLocator>(made.surface.mesh);
  ASSERT_TRUE(cut_to_part(input, made.surface));
  EXPECT_GE(made.surface.part->faces_left_out, 1u);
  EXPECT_TRUE(made.surface.mesh->manifold());
  EXPECT_GT(SurfaceLocator(made.surface.mesh).closest({0, 0, 0}).distance, 0.08) << "the hole is spanned";
}

TEST_F(SurfaceParts, PutSmallerPiecesOffThePart) {
  PointSample sample = sphere(1500, 1);
  for (const Vec3& p : sphere(500, 2).points) sample.points.push_back(p * 0.5 + Vec3{4, 0, 0});
  const Input input = make_input({.positions = sample.points});
  PlacedSurface surface = attempt(input).surface;
  ASSERT_TRUE(cut_to_part(input, surface));
  EXPECT_EQ(surface.part->points, 1500u);
  EXPECT_EQ(surface.part->other_pieces, 500u);
  EXPECT_EQ(surface.inserter, nullptr);
  EXPECT_LT(surface.part->row, 1500u);
  for (Index row = 0; row < 2000; ++row)
    EXPECT_EQ(surface.places[row].state, row < 1500 ? Place::State::on_surface : Place::State::off_part);
  EXPECT_EQ(surface.part->reach.size(), surface.mesh->vertex_count());
  EXPECT_TRUE(within_reach(surface, surface.places[7].at, sample.points[7]));
  EXPECT_FALSE(within_reach(surface, surface.places[7].at, sample.points[7] * 2));
}

}  // namespace
}  // namespace geodrome::test
