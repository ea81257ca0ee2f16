// SPDX-License-Identifier: MIT
// The estimate by itself; what it is worth on samples is measured in tests/tools/bench.
#include "engine/smooth/error_estimate.hpp"

#include <gtest/gtest.h>

#include "tests/engine/smooth/smooth_fixture.hpp"

namespace geodrome::test {
namespace {

using Sphere = Ellipsoid;

/// A surface that is a ball's, of another radius than that which the vertices of the mesh lie on.
struct Raised : Sphere {
  double by = 0;

  template <class T>
  Vector<T> onto(const Vector<T>& p) const {
    return T(1 + by) * unit(p);
  }
};

TEST(LengthError, IsTheSameHoweverAPieceIsCut) {
  LengthError whole, halves;
  whole.add_smooth(1e-3, 0.2, 1), whole.add_flat(3, 0.1);
  for (int i = 0; i < 2; ++i) halves.add_smooth(1e-3, 0.1, 0.5), halves.add_flat(1.5, 0.1);
  EXPECT_NEAR(halves.value(), whole.value(), 1e-15);
}

TEST(LengthError, OfSmoothPiecesGrowsLikeTheRootOfTheirNumber) {
  LengthError one, hundred;
  one.add_smooth(1e-3, 0.2, 1);
  for (int i = 0; i < 100; ++i) hundred.add_smooth(1e-3, 0.2, 1);
  EXPECT_NEAR(hundred.value(), 10 * one.value(), 1e-15);
}

TEST(LengthError, OfFlatPiecesGrowsLikeTheirNumber) {
  LengthError one, hundred;
  one.add_flat(1, 0.1);
  for (int i = 0; i < 100; ++i) hundred.add_flat(1, 0.1);
  EXPECT_NEAR(hundred.value(), 100 * one.value(), 1e-13);
}

TEST(LengthError, BetweenTwoOthersGoesFromOneToTheOther) {
  LengthError less, more;
  less.add_smooth(1e-3, 0.2, 1), more.add_smooth(3e-3, 0.2, 1), more.add_flat(1, 0.1);
  EXPECT_EQ(LengthError::between(less, more, 0).value(), less.value());
  EXPECT_EQ(LengthError::between(less, more, 1).value(), more.value());
  EXPECT_GT(LengthError::between(less, more, 0.5).value(), less.value());
  EXPECT_LT(LengthError::between(less, more, 0.5).value(), more.value());
}

TEST(LengthError, IsNothingInAPlane) {
  LengthError error;
  error.add_smooth(1e-3, 0, 1), error.add_flat(1, 0), error.add_extrapolation(0);
  EXPECT_EQ(error.value(), 0);
}

TEST(ExpectedErrors, AreAShareOfTheDeviationOfASurfaceThroughTheVertices) {
  const MeshPtr mesh = mesh_of(Sphere{}, 320);
  const std::vector<double> stated(mesh->face_count(), 1e-3);
  for (const double expected : expected_errors(*mesh, AnalyticSurface<Sphere>(mesh), stated)) {
    EXPECT_GT(expected, 1e-4);
    EXPECT_LT(expected, 5e-4);
  }
}

TEST(ExpectedErrors, AreAsLargeAsTheDeviationOfASurfaceThatPassesByTheVertices) {
  const MeshPtr mesh = mesh_of(Sphere{}, 320);
  const AnalyticSurface<Raised> surface(mesh, {.by = 5e-4});
  for (const double expected : expected_errors(*mesh, surface, std::vector<double>(mesh->face_count(), 1e-3))) {
    EXPECT_GT(expected, 1e-3);
    EXPECT_LT(expected, 2e-3);
  }
}

TEST(ExpectedErrors, AskNothingOfFacesThatAreNotTrusted) {
  const MeshPtr mesh = mesh_of(Sphere{}, 320);
  struct Silent final : SmoothSurface {
    double deviation(Index) const override { return infinity; }
    void evaluate(std::span<const SmoothPlace>, std::span<SmoothPoint>) const override { ADD_FAILURE(); }
    std::size_t bytes() const override { return 0; }
  };
  for (const double expected : expected_errors(*mesh, Silent(), std::vector<double>(mesh->face_count(), infinity)))
    EXPECT_EQ(expected, infinity);
}

}  // namespace
}  // namespace geodrome::test
