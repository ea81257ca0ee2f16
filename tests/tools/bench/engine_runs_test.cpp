// SPDX-License-Identifier: MIT
#include "tools/bench/samples/engine_runs.hpp"

#include <gtest/gtest.h>

#include "tools/bench/samples/distance_errors.hpp"

namespace geodrome::bench {
namespace {

EngineRun run_of(const ManifoldTask& task, Metric metric) {
  Variant variant = variants_of({}).front();
  variant.metric = metric;
  return engine_distances(task, variant, {.threads = 1});
}

TEST(EngineDistances, OnTheSmoothSurfaceAreAtMostATenthAsFarFromTheTruth) {
  const PluginHost host;
  for (const auto& [shape, points] : {std::pair{"sphere", std::size_t{600}}, {"torus", 1500}}) {
    TaskMaker maker(shape, {.faces = 5000, .targets = 100, .near = 20}, host);
    const ManifoldTask task = maker.make({shape, "uniform", points, 1}, 2);
    const EngineRun flat = run_of(task, Metric::flat), smooth = run_of(task, Metric::smooth);
    EXPECT_FALSE(flat.estimated_error);
    ASSERT_TRUE(smooth.estimated_error && smooth.smooth_share);
    EXPECT_GT(*smooth.smooth_share, 0.9) << shape;
    const DistanceErrors before = distance_errors(task.truth, flat.distances);
    const DistanceErrors after = distance_errors(task.truth, smooth.distances, *smooth.estimated_error);
    EXPECT_LT(after.far.mean, 0.1 * before.far.mean) << shape;
    EXPECT_LT(after.near.mean, 0.2 * before.near.mean) << shape;
    EXPECT_GT(after.far.within, 9 * after.far.pairs / 10) << shape;
    EXPECT_EQ(before.far.pairs, after.far.pairs);
  }
}

TEST(DistanceErrors, CountThePairsThatAreWithinAnEstimate) {
  const std::vector<std::vector<double>> truth{{1, 1, 0.5, 0.01, 0}}, computed{{1.1, 0.98, 0.5, 0.02, 0}};
  const DistanceErrors errors = distance_errors(truth, computed, 0.05);
  EXPECT_EQ(errors.far.pairs, 3u);
  EXPECT_EQ(errors.far.within, 2u);
  EXPECT_EQ(errors.near.within, 0u);
  EXPECT_EQ(distance_errors(truth, computed).far.within, 1u);
  EXPECT_DOUBLE_EQ(errors.far.largest(), errors.far.largest_over);
}

}  // namespace
}  // namespace geodrome::bench
