// SPDX-License-Identifier: MIT
#include "engine/checks/lipschitz.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tests/plugins_for_tests/exact_solver.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome {
namespace {

using namespace test;

constexpr double rounding = 1e-12;

/// Exact distances of all vertices of a mesh from one source.
struct Field {
  MeshPtr mesh;
  Source source;
  std::vector<double> values = distances(ExactSolver(), mesh, source.at);

  double too_far(double limit = infinity) const { return worst_too_far(*mesh, values, 1, limit).excess; }
  double too_near(double limit = infinity) const {
    return worst_too_near(*mesh, values, 1, limit, {&source, 1}).excess;
  }
};

std::vector<Field> right_fields() {
  const MeshPtr torus = bumpy_torus(24, 16, 0.1, 3), rough = terrain(15, 2, 7);
  return {{torus, {torus->at_vertex(7), 0}},
          {torus, {{11, {0.2, 0.5, 0.3}}, 0}},
          {rough, {rough->at_vertex(0), 0}},
          {rough, {{200, {0.5, 0.5, 0}}, 0}},
          {both(rough, torus), {{3, {0, 0.1, 0.9}}, 0}}};
}

TEST(Lipschitz, FitsExactDistances) {
  for (const Field& field : right_fields()) {
    EXPECT_LT(field.too_far(), rounding);
    EXPECT_LT(field.too_near(), rounding);
  }
}

TEST(Lipschitz, FitsDistancesUpToALimit) {
  for (Field& field : right_fields()) {
    for (double& value : field.values)
      if (value > 1.5) value = infinity;
    EXPECT_LT(field.too_far(1.5), rounding);
    EXPECT_LT(field.too_near(1.5), rounding);
    EXPECT_EQ(field.too_far(), infinity) << "without a limit what is not reached is lost";
  }
}

TEST(Lipschitz, NamesTheVertexThatIsTooFar) {
  Field field = right_fields()[0];
  field.values[100] += 1;
  const MisfitVertex misfit = worst_too_far(*field.mesh, field.values, 1, infinity);
  EXPECT_EQ(misfit.vertex, 100u);
  const Triangle& corners = field.mesh->triangles()[misfit.face];
  EXPECT_NE(std::ranges::find(corners, 100u), corners.end());
  EXPECT_GT(misfit.excess, 0.5);
}

TEST(Lipschitz, FindsADistanceThatIsTooShortByItsNeighbours) {
  Field field = right_fields()[2];
  const Index vertex = 112;
  field.values[vertex] *= 0.8;
  EXPECT_GT(field.too_far(), 0.1);
  EXPECT_GT(field.too_near(), 0.1);
}

TEST(Lipschitz, FindsDistancesThatBeginWhereNoSourceIs) {
  Field field = right_fields()[2];
  // As if a second source were there, which nobody named: no distance jumps.
  const std::vector<double> other = distances(ExactSolver(), field.mesh, field.mesh->at_vertex(200));
  std::ranges::transform(field.values, other, field.values.begin(), [](double a, double b) { return std::min(a, b); });
  EXPECT_LT(field.too_far(), rounding);
  EXPECT_GT(field.too_near(), 0.1);
  const Source both_sources[] = {field.source, {field.mesh->at_vertex(200), 0}};
  EXPECT_LT(worst_too_near(*field.mesh, field.values, 1, infinity, both_sources).excess, rounding);
}

TEST(Lipschitz, WhatIsNoNumberIsWorst) {
  Field field = right_fields()[0];
  field.values[5] = std::nan("");
  EXPECT_EQ(field.too_far(), infinity);
}

TEST(Lipschitz, AFactorLeavesThatMuchRoom) {
  Field field = right_fields()[1];
  for (std::size_t v = 0; v < field.values.size(); ++v) field.values[v] *= v % 3 == 0 ? 1.1 : 1;
  EXPECT_GT(field.too_far(), 0.01);
  EXPECT_LT(worst_too_far(*field.mesh, field.values, 1.1, infinity).excess, rounding);
  EXPECT_LT(worst_too_near(*field.mesh, field.values, 1.1, infinity, {&field.source, 1}).excess, rounding);
}

TEST(Lipschitz, BoundsOfFacesHoldAtTheirPoints) {
  for (const Field& field : right_fields()) {
    const std::vector<double> bounds = bounds_of_faces(*field.mesh, field.values);
    for (Index face = 0; face < field.mesh->face_count(); ++face)
      for (const Index v : field.mesh->triangles()[face]) EXPECT_LE(field.values[v], bounds[face]);
  }
}

}  // namespace
}  // namespace geodrome
