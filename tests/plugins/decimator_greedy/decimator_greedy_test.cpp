// SPDX-License-Identifier: MIT
#include "plugins/decimator_greedy/greedy_decimation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <tuple>

#include "plugins/control_lipschitz/lipschitz_control.hpp"
#include "plugins/tangent_pca/pca_tangents.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

class Context : public QuietContext {
 public:
  explicit Context(std::uint64_t seed = 0, unsigned threads = 2) : seed_(seed), threads_(threads) {}
  std::uint64_t seed() const noexcept override { return seed_; }
  unsigned threads() const noexcept override { return threads_; }
  void measure(std::string_view name, double value) override { measured[std::string(name)] = value; }

  std::map<std::string, double> measured;

 private:
  std::uint64_t seed_;
  unsigned threads_;
};

Control control_of(const PointSample& sample) {
  Context context;
  const Tangents tangents = PcaTangents(OptionValues(pca_options)).estimate(sample, context);
  return LipschitzControl(OptionValues(lipschitz_options)).evaluate(sample, tangents, context);
}

Control constant(std::size_t n, double psi) {
  return {std::vector(n, psi), std::vector(n, psi), std::vector(n, PointState::ok)};
}

std::vector<PointSample> samples() {
  return {test::torus(3000, 1),
          test::torus(3000, 2, 10),
          test::ellipsoid(3000, 3),
          test::plane(2000, 4),
          test::plane_lattice(40, 40),
          test::moved(test::torus(2000, 5), 1e-6, {}),
          test::moved(test::torus(2000, 6), 1e6, {1e6, 1e6, 1e6})};
}

std::vector<PointSample> closed_samples() {
  return {test::torus(3000, 1), test::torus(3000, 2, 10), test::ellipsoid(3000, 3),
          test::moved(test::torus(2000, 5), 1e-6, {}), test::moved(test::torus(2000, 6), 1e6, {1e6, 1e6, 1e6})};
}

TEST(DecimatorGreedy, Lemma6HoldsOnClosedSamplesAndIsMeasured) {
  for (const PointSample& sample : closed_samples()) {
    const Control control = control_of(sample);
    Context context;
    const std::vector<Index> kept = GreedyDecimation().select(sample, control, context);
    double worst = std::numeric_limits<double>::infinity();
    for (const Index a : kept)
      for (const Index b : kept)
        if (a != b) worst = std::min(worst, distance(sample.points[a], sample.points[b]) / control.psi[a]);
    EXPECT_GT(worst, 17.0 / 18);
    EXPECT_EQ(context.measured.at("lemma_6_worst_ratio"), worst);
  }
}

/// The smallest distance of a kept point from another, over psi, where both are no nearer to the border than `inner`.
double worst_ratio_inside(const PointSample& plane, const Control& control, const std::vector<Index>& kept,
                          double inner) {
  const auto inside = [&](const Vec3& p) { return std::min({p.x, 1 - p.x, p.y, 1 - p.y}) > inner; };
  double worst = std::numeric_limits<double>::infinity();
  for (const Index a : kept)
    for (const Index b : kept) {
      const Vec3 &p = plane.points[a], &q = plane.points[b];
      if (a != b && inside(p) && inside(q)) worst = std::min(worst, distance(p, q) / control.psi[a]);
    }
  return worst;
}

TEST(DecimatorGreedy, KeepsTheRimOfAnOpenSampleAndThinsTheRest) {
  const PointSample sample = test::plane(4000, 4);
  const Control control = control_of(sample);
  Context context;
  const std::vector<Index> kept = GreedyDecimation().select(sample, control, context);
  EXPECT_LT(kept.size(), 1300U);
  EXPECT_GT(worst_ratio_inside(sample, control, kept, 0.08), 17.0 / 18) << "Lemma 6 holds away from the rim";
  EXPECT_GT(context.measured.at("lemma_6_worst_ratio"), 17.0 / 18);
  double low = 1, high = 0;  // the corners' own neighbourhoods
  for (const Index s : kept) {
    low = std::min(low, sample.points[s].x + sample.points[s].y);
    high = std::max(high, sample.points[s].x + sample.points[s].y);
  }
  const auto sum = [](const Vec3& p) { return p.x + p.y; };
  EXPECT_NEAR(low, sum(*std::ranges::min_element(sample.points, {}, sum)), 0.01);
  EXPECT_NEAR(high, sum(*std::ranges::max_element(sample.points, {}, sum)), 0.01);
}

TEST(DecimatorGreedy, KeepsMostOfASheetThatBendsTooMuchForPsi) {
  // A gutter of radius 0.5: psi is about 0.2 with 500 points, 0.05 with 8000.
  const auto gutter = [](std::size_t n) {
    test::Random random(n);
    PointSample sample;
    while (sample.size() < n) {
      const double angle = random.uniform(0, std::numbers::pi), along = random.uniform(0, 3);
      sample.points.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle), along});
    }
    return sample;
  };
  for (const auto& [points, least, most] : {std::tuple(500U, 300U, 500U), std::tuple(8000U, 1000U, 3000U)}) {
    const PointSample sample = gutter(points);
    Context context;
    const std::size_t kept = GreedyDecimation().select(sample, control_of(sample), context).size();
    EXPECT_GE(kept, least) << points;
    EXPECT_LE(kept, most) << points;
  }
}

TEST(DecimatorGreedy, EveryRemovedPointIsInTheBallOfAKeptOne) {
  for (const PointSample& sample : samples()) {
    const Control control = control_of(sample);
    Context context;
    const std::vector<Index> kept = GreedyDecimation().select(sample, control, context);
    for (const Vec3& p : sample.points)
      ASSERT_TRUE(std::any_of(kept.begin(), kept.end(),
                              [&](Index s) { return distance(p, sample.points[s]) <= control.psi[s]; }));
  }
}

TEST(DecimatorGreedy, KeepsAboutAQuarterOfAUniformSample) {
  const PointSample sample = test::torus(20000, 1);
  const Control control = control_of(sample);
  for (const std::uint64_t seed : {0, 1, 2}) {
    Context context(seed);
    const double share = static_cast<double>(GreedyDecimation().select(sample, control, context).size()) / 20000;
    EXPECT_GT(share, 0.2);
    EXPECT_LT(share, 0.3);
  }
}

TEST(DecimatorGreedy, TheBallIsClosed) {
  const PointSample sample = test::plane_lattice(30, 1);
  Context context;
  const std::vector<Index> kept = GreedyDecimation().select(sample, constant(30, 1), context);
  for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_GE(kept[i] - kept[i - 1], 2U);
}

TEST(DecimatorGreedy, TheSeedDecidesTheOrder) {
  const PointSample sample = test::torus(2000, 1);
  const Control control = control_of(sample);
  Context zero(0), zero_again(0), one(1);
  const std::vector<Index> kept = GreedyDecimation().select(sample, control, zero);
  EXPECT_EQ(GreedyDecimation().select(sample, control, zero_again), kept);
  EXPECT_NE(GreedyDecimation().select(sample, control, one), kept);
}

TEST(DecimatorGreedy, APsiThatIsNoControlFunctionIsRefusedByName) {
  // Far from Lipschitz: two near points, of which one has a large psi and is not the first in every order.
  const PointSample sample{{{0, 0, 0}, {1, 0, 0}, {10, 0, 0}}};
  Control control = constant(3, 0.5);
  control.psi[0] = 5;
  std::size_t refused = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Context context(seed);
    try {
      const std::vector<Index> kept = GreedyDecimation().select(sample, control, context);
      EXPECT_EQ(kept, (std::vector<Index>{0, 2}));
    } catch (const NumericalError& error) {
      EXPECT_NE(std::string(error.what()).find("points 0 and 1"), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
  EXPECT_LT(refused, 20U);
}

TEST(DecimatorGreedy, OneBallOverEverythingKeepsOnePoint) {
  const PointSample sample = test::torus(500, 1);
  Context context;
  EXPECT_EQ(GreedyDecimation().select(sample, constant(500, 10), context).size(), 1U);
  EXPECT_EQ(context.measured.count("lemma_6_worst_ratio"), 0U);
}

TEST(DecimatorGreedy, NoPointsGiveNoPoints) {
  Context context;
  EXPECT_TRUE(GreedyDecimation().select({}, {}, context).empty());
}

}  // namespace
}  // namespace geodrome
