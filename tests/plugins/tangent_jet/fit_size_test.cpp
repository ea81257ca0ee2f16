// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/fit_size.hpp"

#include <gtest/gtest.h>

#include "tests/plugins/tangent_jet/fitted_surface.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

FitSize size_for(const PointSample& sample, unsigned threads = 2) {
  test::ThreadsContext context(threads);
  const JetPoints points(sample, JetTangents(OptionValues(jet_options, "")).estimate(sample, context));
  EXPECT_GT(points.sigma, 0);
  return best_fit_size(points, points.places.points(), context);
}

FitSize size_for_torus(std::size_t points, double noise) {
  return size_for(shapes::sample("torus", {.points = points, .noise = noise}));
}

TEST(FitSize, GrowsWithNoise) {
  const FitSize little = size_for_torus(8000, 0.001), much = size_for_torus(8000, 0.01);
  EXPECT_LT(little.points, much.points);
  EXPECT_LT(little.left_out, much.left_out);
}

TEST(FitSize, GrowsWithTheNumberOfPoints) {
  EXPECT_LT(size_for_torus(2000, 0.005).points, size_for_torus(8000, 0.005).points);
}

TEST(FitSize, IsTheMostWhereNothingIsLeftOut) {
  EXPECT_EQ(size_for(shapes::sample("plane", {.points = 4000, .noise = 0.005})).points, most_jet_points);
}

TEST(FitSize, HeightsAreBetterThanWithHalfOrTwiceAsMany) {
  // The true mean square of heights, against the equation of the torus.
  const PointSample sample = shapes::sample("torus", {.points = 4000, .noise = 0.005});
  test::ThreadsContext context(2);
  const JetPoints points(sample, JetTangents(OptionValues(jet_options, "")).estimate(sample, context));
  const FitSize best = best_fit_size(points, points.places.points(), context);
  const auto error = [&](std::size_t count) {
    double squares = 0;
    std::vector<Neighbour> around;
    for (Index i = 0; i < points.raw.size(); i += 16) {
      const Vec3& vertex = points.places.points()[i];
      points.places.nearest(vertex, count, around);
      const QuarticFit fit =
          fit_quartic(points.raw, around, vertex, points.normal[i], {noisy_decay, false, best.degree});
      const double off = test::distance_off_shape("torus", vertex + fit.quartic.c[0] * fit.quartic.n);
      squares += off * off;
    }
    return squares;
  };
  const double chosen = error(best.points);
  EXPECT_LT(chosen, 1.1 * error(best.points / 2));
  EXPECT_LT(chosen, 1.1 * error(best.points * 2));
}

TEST(FitSize, DoesNotDependOnThreads) {
  const PointSample sample = shapes::sample("torus", {.points = 2000, .noise = 0.005});
  const FitSize one = size_for(sample, 1), four = size_for(sample, 4);
  EXPECT_EQ(one.points, four.points);
  EXPECT_EQ(one.degree, four.degree);
  EXPECT_EQ(one.left_out, four.left_out);
}

TEST(FitSize, FewPointsAreNoError) {
  for (const std::size_t count : {0, 1, 10, 31, 40}) {
    const PointSample sample = test::plane(count, 1);
    Tangents tangents;
    for (const Vec3& p : sample.points) tangents.plane.push_back({p, {0, 0, 1}, 0});
    tangents.state.assign(count, PointState::ok);
    tangents.sigma = 0.1;
    test::ThreadsContext context(2);
    EXPECT_EQ(best_fit_size(JetPoints(sample, tangents), sample.points, context).points, fewest_jet_points) << count;
  }
}

}  // namespace
}  // namespace geodrome
