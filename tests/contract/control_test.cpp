// SPDX-License-Identifier: MIT
// What every control plugin must do.
#include <gtest/gtest.h>

#include <cmath>

#include "contract/sample_context.hpp"
#include "geodrome/control_function.hpp"
#include "support/samples.hpp"

namespace geodrome {
namespace {

using test::ContractContext;

struct Case {
  PointSample sample;
  Tangents tangents;
};

class ControlContract : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    plugins_ = test::plugins_of_stage<ControlFunction>();
    const Plugin<TangentEstimator> pca = PluginHost().load<TangentEstimator>("pca");
    for (const PointSample& sample :
         {test::torus(2000, 1, 10), test::with_noise(test::ellipsoid(1500, 2), 0.02, 3), test::plane(800, 4),
          test::plane_grid(25, 30), test::moved(test::torus(1000, 5), 1e-6, {}),
          test::moved(test::torus(1000, 6), 1e6, {1e6, 1e6, 1e6})}) {
      ContractContext context;
      cases_.push_back(
          {sample, pca.call([&](const TangentEstimator& stage) { return stage.estimate(sample, context); })});
    }
  }
  void SetUp() override { ASSERT_FALSE(plugins_.empty()) << "no control plugin was found"; }
  static Control evaluate(const Plugin<ControlFunction>& plugin, const Case& c, RunContext& context) {
    return plugin.call([&](const ControlFunction& stage) { return stage.evaluate(c.sample, c.tangents, context); });
  }

  static inline std::vector<Plugin<ControlFunction>> plugins_;
  static inline std::vector<Case> cases_;
};

TEST_F(ControlContract, GivesPositiveFiniteValuesForEachPoint) {
  for (const auto& plugin : plugins_)
    for (const Case& c : cases_) {
      ContractContext context;
      const Control control = evaluate(plugin, c, context);
      ASSERT_EQ(control.phi.size(), c.sample.size());
      ASSERT_EQ(control.psi.size(), c.sample.size());
      ASSERT_EQ(control.state.size(), c.sample.size());
      for (std::size_t i = 0; i < c.sample.size(); ++i) {
        ASSERT_TRUE(control.phi[i] > 0 && std::isfinite(control.phi[i])) << plugin.info.full_name();
        ASSERT_TRUE(control.psi[i] > 0 && std::isfinite(control.psi[i])) << plugin.info.full_name();
      }
      EXPECT_TRUE(context.progress_in_range);
    }
}

TEST_F(ControlContract, PsiIsOneEighteenthLipschitz) {
  test::Random random(1);
  for (const auto& plugin : plugins_)
    for (const Case& c : cases_) {
      ContractContext context;
      const Control control = evaluate(plugin, c, context);
      for (int trial = 0; trial < 20000; ++trial) {
        const std::size_t i = random.below(c.sample.size()), j = random.below(c.sample.size());
        ASSERT_LE(std::abs(control.psi[i] - control.psi[j]), distance(c.sample.points[i], c.sample.points[j]) / 18)
            << plugin.info.full_name();
      }
    }
}

TEST_F(ControlContract, DroppedPointsTakePartInNothing) {
  for (const auto& plugin : plugins_)
    for (const Case& c : cases_) {
      // Every fifth point is put elsewhere and dropped: the others must not notice.
      Case with = c, without;
      test::Random random(2);
      for (std::size_t i = 0; i < c.sample.size(); ++i) {
        if (i % 5 == 0) {
          with.tangents.state[i] = PointState::dropped;
          with.sample.points[i] = c.sample.points[i] + 0.1 * (c.sample.points[0] - c.sample.points[1]);
          continue;
        }
        without.sample.points.push_back(c.sample.points[i]);
        without.tangents.plane.push_back(c.tangents.plane[i]);
        without.tangents.state.push_back(c.tangents.state[i]);
      }
      ContractContext context;
      const Control all = evaluate(plugin, with, context), rest = evaluate(plugin, without, context);
      for (std::size_t i = 0, k = 0; i < c.sample.size(); ++i) {
        if (i % 5 == 0) {
          ASSERT_TRUE(std::isnan(all.phi[i]) && std::isnan(all.psi[i])) << plugin.info.full_name();
          ASSERT_EQ(all.state[i], PointState::dropped);
          continue;
        }
        ASSERT_EQ(all.phi[i], rest.phi[k]) << plugin.info.full_name();
        ASSERT_EQ(all.psi[i], rest.psi[k]) << plugin.info.full_name();
        ASSERT_EQ(all.state[i], rest.state[k]) << plugin.info.full_name();
        ++k;
      }
    }
}

TEST_F(ControlContract, TheNumberOfThreadsChangesNoBit) {
  for (const auto& plugin : plugins_)
    for (const Case& c : cases_) {
      ContractContext one(1), four(4);
      const Control a = evaluate(plugin, c, one), b = evaluate(plugin, c, four);
      ASSERT_EQ(a.phi, b.phi) << plugin.info.full_name();
      ASSERT_EQ(a.psi, b.psi) << plugin.info.full_name();
      ASSERT_EQ(a.state, b.state) << plugin.info.full_name();
    }
}

TEST_F(ControlContract, StopsWhenCancelled) {
  for (const auto& plugin : plugins_) {
    ContractContext context;
    context.stop = true;
    EXPECT_THROW(evaluate(plugin, cases_.front(), context), Cancelled) << plugin.info.full_name();
  }
}

}  // namespace
}  // namespace geodrome
