// SPDX-License-Identifier: MIT
// What every tangent plugin must do.
#include <gtest/gtest.h>

#include <cmath>

#include "contract/sample_context.hpp"
#include "geodrome/tangent_estimator.hpp"
#include "support/samples.hpp"

namespace geodrome {
namespace {

using test::ContractContext;

class TangentContract : public testing::Test {
 protected:
  static void SetUpTestSuite() { plugins_ = test::plugins_of_stage<TangentEstimator>(); }
  void SetUp() override { ASSERT_FALSE(plugins_.empty()) << "no tangent plugin was found"; }
  static Tangents estimate(const Plugin<TangentEstimator>& plugin, const PointSample& sample, RunContext& context) {
    return plugin.call([&](const TangentEstimator& stage) { return stage.estimate(sample, context); });
  }

  static inline std::vector<Plugin<TangentEstimator>> plugins_;
};

std::vector<PointSample> samples() {
  return {test::torus(2000, 1, 10),
          test::with_noise(test::ellipsoid(1500, 2), 0.02, 3),
          test::plane(800, 4),
          test::plane_grid(25, 30),
          test::moved(test::torus(1000, 5), 1e-6, {}),
          test::moved(test::torus(1000, 6), 1e6, {1e6, 1e6, 1e6})};
}

TEST_F(TangentContract, GivesOneUnitNormalAndStateForEachPoint) {
  for (const auto& plugin : plugins_)
    for (const PointSample& sample : samples()) {
      ContractContext context;
      const Tangents tangents = estimate(plugin, sample, context);
      ASSERT_EQ(tangents.plane.size(), sample.size());
      ASSERT_EQ(tangents.state.size(), sample.size());
      for (const TangentPlane& plane : tangents.plane) {
        ASSERT_NEAR(norm(plane.normal), 1, 1e-12) << plugin.info.full_name();
        ASSERT_TRUE(is_finite(plane.origin));
        ASSERT_GE(plane.residual, 0);
      }
      ASSERT_GE(tangents.sigma, 0);
      EXPECT_TRUE(context.progress_in_range);
    }
}

TEST_F(TangentContract, NormalsOfATorusAreRight) {
  const PointSample sample = test::torus(10000, 7);
  for (const auto& plugin : plugins_) {
    ContractContext context;
    const Tangents tangents = estimate(plugin, sample, context);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const Vec3& p = sample.points[i];
      const double ring = std::hypot(p.x, p.y);
      const Vec3 normal = Vec3{p.x - p.x / ring, p.y - p.y / ring, p.z} / 0.4;
      wrong += norm(cross(tangents.plane[i].normal, normal)) > 0.2;  // 11 degrees
    }
    EXPECT_EQ(wrong, 0U) << plugin.info.full_name();
  }
}

TEST_F(TangentContract, TheNumberOfThreadsChangesNoBit) {
  for (const auto& plugin : plugins_)
    for (const PointSample& sample : samples()) {
      ContractContext one(1), four(4);
      const Tangents a = estimate(plugin, sample, one), b = estimate(plugin, sample, four);
      ASSERT_EQ(a.state, b.state);
      ASSERT_EQ(a.sigma, b.sigma);
      for (std::size_t i = 0; i < sample.size(); ++i) {
        ASSERT_EQ(a.plane[i].normal, b.plane[i].normal) << plugin.info.full_name();
        ASSERT_EQ(a.plane[i].origin, b.plane[i].origin) << plugin.info.full_name();
        ASSERT_EQ(a.plane[i].residual, b.plane[i].residual) << plugin.info.full_name();
      }
    }
}

TEST_F(TangentContract, ASampleThatSpansNoPlaneIsRefused) {
  const std::vector<PointSample> refused = {
      {}, {{{0, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}};
  for (const auto& plugin : plugins_)
    for (const PointSample& sample : refused) {
      ContractContext context;
      EXPECT_THROW(estimate(plugin, sample, context), SampleError) << plugin.info.full_name() << ' ' << sample.size();
    }
}

TEST_F(TangentContract, StopsWhenCancelled) {
  for (const auto& plugin : plugins_) {
    ContractContext context;
    context.stop = true;
    EXPECT_THROW(estimate(plugin, test::torus(5000, 1), context), Cancelled) << plugin.info.full_name();
  }
}

}  // namespace
}  // namespace geodrome
