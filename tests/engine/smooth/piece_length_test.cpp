// SPDX-License-Identifier: MIT
#include "engine/smooth/piece_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/smooth/smooth_fixture.hpp"

namespace geodrome::test {
namespace {

using Sphere = Ellipsoid;

/// A place above a face of a mesh, and what lies above it when it moves.
template <class Shape>
class Mover {
 public:
  Mover(const MeshPtr& mesh, Index face, const std::array<double, 3>& b)
      : mesh_(*mesh), surface_(mesh), place_{{face, b}, {}} {
    const auto [p, q, r] = mesh->corners(face);
    side_ = q - p, direction_ = side_ / norm(side_);
  }
  SmoothPoint at(double moved) const {
    SmoothPlace place{place_.at, direction_};
    place.at.b[0] -= moved / norm(side_), place.at.b[1] += moved / norm(side_);
    SmoothPoint point;
    surface_.evaluate({&place, 1}, {&point, 1});
    return point;
  }

 private:
  const SurfaceMesh& mesh_;
  AnalyticSurface<Shape> surface_;
  SmoothPlace place_;
  Vec3 side_, direction_;
};

TEST(PieceLength, IsExactOnASphereButForTheSixthPower) {
  const auto point = [](double angle) {
    const Vec3 p{std::cos(angle), std::sin(angle), 0};
    return SmoothPoint{p, p, {}, {}, {}};
  };
  for (const double angle : {0.1, 0.2, 0.4}) {
    const double error = std::abs(length_between(point(0), point(angle)) / angle - 1);
    EXPECT_LT(error, std::pow(angle / 2, 6) / 300);  // 31 / 15120 of (angle / 2)^6 is left
    EXPECT_GT(error, std::pow(angle / 2, 6) / 1000);
  }
}

TEST(PieceLength, CountsTheSidesThatTheNormalsPointTo) {
  const Vec3 p{1, 0, 0}, q{std::cos(0.3), std::sin(0.3), 0};
  const double same = length_between({p, p, {}, {}, {}}, {q, q, {}, {}, {}});
  EXPECT_EQ(length_between({p, p, {}, {}, {}}, {q, -q, {}, {}, {}}), same);
}

TEST(PieceLength, OfOnePointIsZero) {
  const Vec3 p{1, 0, 0};
  EXPECT_EQ(length_between({p, p, {}, {}, {}}, {p, p, {}, {}, {}}), 0);
}

TEST(PieceLength, HasTheDerivativesOfTheLength) {
  const MeshPtr mesh = mesh_of(Star{}, 320);
  const Mover<Star> from(mesh, 7, {0.2, 0.5, 0.3}), to(mesh, mesh->twins()[21] / 3, {0.3, 0.3, 0.4});
  const PieceLength found = moving_length(from.at(0), to.at(0));
  constexpr double h = 3e-4;
  const auto length = [&](double s, double t) { return length_between(from.at(s), to.at(t)); };
  const double at = length(0, 0);
  EXPECT_NEAR(found.value, at, 1e-15);
  EXPECT_NEAR(found.s, (length(h, 0) - length(-h, 0)) / (2 * h), 1e-5);
  EXPECT_NEAR(found.t, (length(0, h) - length(0, -h)) / (2 * h), 1e-5);
  EXPECT_NEAR(found.ss, (length(h, 0) - 2 * at + length(-h, 0)) / (h * h), 1e-3);
  EXPECT_NEAR(found.tt, (length(0, h) - 2 * at + length(0, -h)) / (h * h), 1e-3);
  EXPECT_NEAR(found.st, (length(h, h) - length(h, -h) - length(-h, h) + length(-h, -h)) / (4 * h * h), 1e-3);
}

}  // namespace
}  // namespace geodrome::test
