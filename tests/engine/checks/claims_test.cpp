// SPDX-License-Identifier: MIT
#include "engine/checks/claims.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/sample_surfaces.hpp"

namespace geodrome {
namespace {

using test::sampled;
using test::SampledSurface;

Claim claim(const SampledSurface& made, const std::string& code) {
  for (const Claim& c : claims_of(made.surface, 1))
    if (c.code == code) return c;
  ADD_FAILURE() << "no claim " << code;
  return {};
}

TEST(Claims, OfTheOctahedronAreWhatGeometrySays) {
  const SampledSurface made = sampled(test::octahedron(), 0.5);
  const std::pair<const char*, double> expected[] = {{"psi_lipschitz", 0},
                                                     {"lemma_6", 2 * std::numbers::sqrt2},
                                                     {"edge_to_psi", 2 * std::numbers::sqrt2},
                                                     {"circumradius_to_psi", 2 * std::sqrt(2.0 / 3)},
                                                     {"degree", 4},
                                                     {"edge_ratio", 1},
                                                     {"smallest_angle", std::numbers::pi / 3}};
  for (const auto& [code, value] : expected) {
    EXPECT_NEAR(claim(made, code).measured, value, 1e-12) << code;
    EXPECT_TRUE(claim(made, code).holds()) << code;
  }
}

TEST(Claims, NameThePointWhosePsiIsTooSmallForItsEdges) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  made.surface.sample->control.psi[3] = 0.3;
  for (const char* code : {"edge_to_psi", "circumradius_to_psi"}) {
    const Claim found = claim(made, code);
    EXPECT_TRUE(found.fails()) << code;
    EXPECT_EQ(found.places.front().point, 3u) << code;
    EXPECT_EQ(found.places.front().measured, found.measured) << code;
  }
}

TEST(Claims, FindAPsiThatIsTooSteepBetweenNeighbours) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  made.surface.sample->control.psi[3] = 0.6;
  const Claim found = claim(made, "psi_lipschitz");
  EXPECT_TRUE(found.fails());
  EXPECT_NEAR(found.measured, 0.1 / std::numbers::sqrt2, 1e-12);
  EXPECT_EQ(found.places.front().point, 3u);
}

TEST(Claims, FindKeptPointsThatAreTooNear) {
  const SampledSurface made = sampled(test::octahedron(), 1.5);
  EXPECT_TRUE(claim(made, "lemma_6").fails());
}

TEST(Claims, TakeLemma6FromADecimatorThatMeasuredLess) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  made.surface.stages.push_back(test::record_of("decimator", "c", {{"lemma_6_worst_ratio", 0.9}}));
  EXPECT_TRUE(claim(made, "lemma_6").fails());
  EXPECT_EQ(claim(made, "lemma_6").measured, 0.9);
}

TEST(Claims, NameTheCornerOfTheSmallestAngle) {
  const MeshPtr flat = test::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {20, 0.5, 0}}, {{0, 1, 2}, {1, 3, 2}});
  const SampledSurface made = sampled(flat, 1);
  const Claim angle = claim(made, "smallest_angle");
  EXPECT_TRUE(angle.fails());
  EXPECT_EQ(angle.places.front().point, 3u);
  EXPECT_EQ(angle.places.size(), 4u);
  EXPECT_TRUE(claim(made, "edge_ratio").fails());
}

TEST(Claims, CountVerticesThatAreNoSamplePointsWithoutAPlace) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  made.surface.sample->sample_of_vertex.assign(6, no_index);
  const Claim angle = claim(made, "smallest_angle");
  EXPECT_NEAR(angle.measured, std::numbers::pi / 3, 1e-12);
  EXPECT_TRUE(angle.places.empty());
  EXPECT_FALSE(claim(made, "edge_to_psi").is_measured());
}

TEST(Claims, WithoutASurfaceMostAreNotMeasured) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  test::refuse(made);
  EXPECT_TRUE(claim(made, "psi_lipschitz").is_measured());
  const Claim edges = claim(made, "edge_to_psi");
  EXPECT_FALSE(edges.is_measured() || edges.holds() || edges.fails());
  EXPECT_EQ(edges.not_measured, "there is no surface");
}

TEST(Claims, SeePhiOverTheRadiusOfASphere) {
  constexpr double radius = 3, phi = 0.5;
  SampledSurface made = sampled(test::mapped(test::octahedron(), [](Vec3 p) { return radius * p; }), phi);
  for (TangentPlane& plane : made.surface.sample->tangents.plane) plane.normal = plane.origin / radius;
  made.surface.sample->tangents.plane[2].normal =
      -made.surface.sample->tangents.plane[2].normal;  // the sign means nothing
  EXPECT_NEAR(claim_curvature(made.surface).measured, phi / radius, 1e-12);
}

TEST(Claims, SeeTheCurvatureWithoutASurface) {
  SampledSurface made = sampled(test::octahedron(), 0.2);
  for (TangentPlane& plane : made.surface.sample->tangents.plane) plane.normal = plane.origin;
  test::refuse(made);
  EXPECT_NEAR(claim_curvature(made.surface).measured, 0.2, 1e-12);
}

TEST(Claims, FindThePointWhosePhiIsTooLargeForTheCurvature) {
  SampledSurface made = sampled(test::octahedron(), 0.2);
  for (TangentPlane& plane : made.surface.sample->tangents.plane) plane.normal = plane.origin;
  made.surface.sample->control.phi[4] = 0.4;
  const Claim found = claim_curvature(made.surface);
  EXPECT_TRUE(found.fails());
  EXPECT_EQ(found.places.front().point, 4u);
}

TEST(Claims, TakeNoEpsilonFromAShortRim) {
  SampledSurface made = sampled(test::plane_grid(10), 0.2);
  Control& control = made.surface.sample->control;
  control.state[0] = PointState::unbounded;
  made.surface.sample->tangents.plane[0].normal = {1, 0, 0};
  EXPECT_GT(claim_curvature(made.surface).measured, 0);
  EXPECT_EQ(least_epsilon(made.surface), 0);
  const auto most = static_cast<std::ptrdiff_t>(control.state.size() / 8);
  std::fill_n(control.state.begin(), most, PointState::capped);
  EXPECT_EQ(least_epsilon(made.surface), claim_curvature(made.surface).measured) << "much of the sample is on it";
}

TEST(Claims, TakeEpsilonFromAllPointsOfAClosedSurface) {
  SampledSurface made = sampled(test::octahedron(), 0.2);
  for (TangentPlane& plane : made.surface.sample->tangents.plane) plane.normal = plane.origin;
  made.surface.sample->control.phi[4] = 0.8, made.surface.sample->control.state[4] = PointState::capped;
  EXPECT_NEAR(least_epsilon(made.surface), 0.8, 1e-12);
}

TEST(Claims, FindThePointOffTheSurface) {
  SampledSurface made = sampled(test::plane_grid(3), 1);
  made.surface.places[5].position.z += 2.5;
  const Claim found = claim_points_on_surface(made.input, made.surface);
  EXPECT_EQ(found.measured, 2.5);
  EXPECT_EQ(found.places.front().point, 5u);
}

}  // namespace
}  // namespace geodrome
