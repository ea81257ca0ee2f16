// SPDX-License-Identifier: MIT
// How fast lengths approach those of the geodesics of surfaces that are known by formulas, as meshes get finer.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/smooth/smooth_fixture.hpp"

namespace geodrome::test {
namespace {

/// Mean relative errors.
struct Errors {
  double flat = 0, smooth = 0;
};

/// Against a truth that is told the ends, the direction in which the curve begins and its length.
template <class Shape, class Truth>
Errors errors_of(const Shape& shape, std::size_t faces, Truth&& truth) {
  Measured<Shape> measured(mesh_of(shape, faces), shape);
  Errors errors;
  int used = 0;
  for (const auto& [from, to] : vertex_pairs(*measured.mesh, 24, 0.7)) {
    const auto [flat, path] = measured.flat.find(from, to);
    const SmoothLength smooth = measured.shorten(path);
    std::vector<SurfacePoint> points;
    std::vector<Vec3> curve;
    measured.shortening.curve(0, points, curve);
    const double length = truth(curve.front(), curve.back(), curve[1] - curve[0], smooth.length);
    if (!(std::abs(length / flat - 1) < 0.01)) continue;  // the shot went another way round
    errors.flat += std::abs(flat / length - 1), errors.smooth += std::abs(smooth.length / length - 1);
    ++used;
  }
  EXPECT_GE(used, 20);
  return {errors.flat / used, errors.smooth / used};
}

/// Errors fall by 4^3.5 or more where edges become four times as short, and are small beside the flat ones.
template <class Shape, class Truth>
void expect_order_4(const Shape& shape, Truth&& truth) {
  const Errors coarse = errors_of(shape, 1280, truth), fine = errors_of(shape, 20480, truth);
  EXPECT_GT(std::log2(coarse.smooth / fine.smooth) / 2, 3.5) << coarse.smooth << " " << fine.smooth;
  EXPECT_LT(std::log2(coarse.flat / fine.flat) / 2, 2.5) << "flat lengths are of second order";
  EXPECT_LT(coarse.smooth, 1e-3 * coarse.flat);
  EXPECT_LT(fine.smooth, 1e-4 * fine.flat);
}

template <class Shape>
void expect_order_4(const Shape& shape) {
  expect_order_4(shape, [shot = GeodesicShot(shape)](const Vec3& from, const Vec3& to, const Vec3& heading, double l) {
    return shot.length(from, to, heading, l);
  });
}

TEST(ShorteningConvergence, IsOfOrder4OnASphere) {
  expect_order_4(Ellipsoid{}, [](const Vec3& from, const Vec3& to, const Vec3&, double) {
    return std::atan2(norm(cross(from, to)), dot(from, to));
  });
}

TEST(ShorteningConvergence, IsOfOrder4OnAnEllipsoid) { expect_order_4(Ellipsoid{0.8, 0.6}); }

TEST(ShorteningConvergence, IsOfOrder4OnAStarShapedBody) { expect_order_4(Star{}); }

TEST(ShorteningConvergence, IsOfOrder4OnATorus) { expect_order_4(Torus{}); }

}  // namespace
}  // namespace geodrome::test
