// SPDX-License-Identifier: MIT
// What every decimator plugin must do.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "contract/sample_context.hpp"
#include "geodrome/decimator.hpp"
#include "support/samples.hpp"

namespace geodrome {
namespace {

using test::ContractContext;

class DecimatorContract : public testing::Test {
 protected:
  static void SetUpTestSuite() { plugins_ = test::plugins_of_stage<Decimator>(); }
  void SetUp() override { ASSERT_GE(plugins_.size(), 2U) << "greedy and none should be found"; }
  static std::vector<Index> select(const Plugin<Decimator>& plugin, const PointSample& sample, const Control& control,
                                   RunContext& context) {
    return plugin.call([&](const Decimator& stage) { return stage.select(sample, control, context); });
  }

  static inline std::vector<Plugin<Decimator>> plugins_;
};

/// psi = 0.1 + |x| / 20: 1/20-Lipschitz; every seventh point is dropped.
Control control_of(const PointSample& sample) {
  Control control;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const bool dropped = i % 7 == 3;
    const double psi = dropped ? std::numeric_limits<double>::quiet_NaN() : 0.1 + std::abs(sample.points[i].x) / 20;
    control.psi.push_back(psi);
    control.phi.push_back(psi);
    control.state.push_back(dropped ? PointState::dropped : PointState::ok);
  }
  return control;
}

std::vector<PointSample> samples() {
  return {test::torus(3000, 1, 10), test::ellipsoid(2000, 2), test::plane(1000, 3), test::plane_grid(20, 20)};
}

TEST_F(DecimatorContract, KeepsAscendingIndicesOfPointsThatAreNotDropped) {
  for (const auto& plugin : plugins_)
    for (const PointSample& sample : samples()) {
      const Control control = control_of(sample);
      ContractContext context;
      const std::vector<Index> kept = select(plugin, sample, control, context);
      ASSERT_FALSE(kept.empty()) << plugin.info.full_name();
      ASSERT_TRUE(std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()) == kept.end());
      for (const Index i : kept) {
        ASSERT_LT(i, sample.size());
        ASSERT_NE(control.state[i], PointState::dropped) << plugin.info.full_name();
      }
      EXPECT_TRUE(context.progress_in_range);
    }
}

TEST_F(DecimatorContract, EveryPointHasAKeptOneWithinItsPsi) {
  for (const auto& plugin : plugins_)
    for (const PointSample& sample : samples()) {
      const Control control = control_of(sample);
      ContractContext context;
      const std::vector<Index> kept = select(plugin, sample, control, context);
      for (std::size_t i = 0; i < sample.size(); ++i) {
        if (control.state[i] == PointState::dropped) continue;
        ASSERT_TRUE(std::any_of(kept.begin(), kept.end(), [&](Index s) {
          return distance(sample.points[i], sample.points[s]) <= control.psi[s];
        })) << plugin.info.full_name();
      }
    }
}

TEST_F(DecimatorContract, TheNumberOfThreadsChangesNothing) {
  for (const auto& plugin : plugins_)
    for (const PointSample& sample : samples()) {
      ContractContext one(1, 5), four(4, 5);
      const Control control = control_of(sample);
      ASSERT_EQ(select(plugin, sample, control, one), select(plugin, sample, control, four)) << plugin.info.full_name();
    }
}

TEST_F(DecimatorContract, NothingIsKeptWhereAllIsDropped) {
  const PointSample sample = test::torus(100, 1);
  const std::vector<double> none(100, std::numeric_limits<double>::quiet_NaN());
  for (const auto& plugin : plugins_) {
    ContractContext context;
    const Control control{none, none, std::vector(100, PointState::dropped)};
    EXPECT_TRUE(select(plugin, sample, control, context).empty()) << plugin.info.full_name();
  }
}

TEST_F(DecimatorContract, StopsWhenCancelled) {
  const PointSample sample = test::torus(5000, 1);
  for (const auto& plugin : plugins_) {
    ContractContext context;
    context.stop = true;
    EXPECT_THROW(select(plugin, sample, control_of(sample), context), Cancelled) << plugin.info.full_name();
  }
}

}  // namespace
}  // namespace geodrome
