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
    EXPECT_GT(after.far.share_within(2), 0.9) << shape;
    EXPECT_EQ(before.far.pairs, after.far.pairs);
  }
}

struct Sampled {
  const char* shape;
  std::size_t points;
  double noise;
  double largest_share, least_share;  ///< of the paths, on the smooth surface
};

TEST(EngineDistances, AreEstimatedToBeOffByOneToFourTimesWhatTheyAre) {
  const PluginHost host;
  for (const auto& [shape, points, noise, largest_share, least_share] : {Sampled{"ellipsoid", 2000, 0, 1, 0.99},
                                                                         {"bumpy", 2000, 0.001, 1, 0.8},
                                                                         {"trefoil", 2000, 0, 0.3, 0},
                                                                         {"torus", 2000, 0.005, 0.95, 0.5}}) {
    TaskMaker maker(shape, {.faces = 5000, .targets = 60, .near = 1}, host);
    const ManifoldTask task = maker.make({.shape = shape, .sampling = "uniform", .points = points, .noise = noise}, 2);
    const EngineRun run = run_of(task, Metric::smooth);
    ASSERT_TRUE(run.estimated_error && run.smooth_share);
    EXPECT_GE(*run.smooth_share, least_share) << shape;
    EXPECT_LE(*run.smooth_share, largest_share + 1e-12) << shape;
    const DistanceErrors::Group far = distance_errors(task.truth, run.distances, *run.estimated_error).far;
    EXPECT_GT(*run.estimated_error, far.mean) << shape;
    EXPECT_LT(*run.estimated_error, 4 * far.mean) << shape;
    EXPECT_GT(far.share_within(2), 0.9) << shape;
  }
}

TEST(DistanceErrors, CountThePairsThatAreWithinAnEstimate) {
  const std::vector<std::vector<double>> truth{{1, 1, 0.5, 0.01, 0}}, computed{{1.15, 0.98, 0.5, 0.02, 0}};
  const DistanceErrors errors = distance_errors(truth, computed, 0.05);
  EXPECT_EQ(errors.far.pairs, 3u);
  EXPECT_EQ(errors.far.within, (std::array<std::size_t, 3>{2, 2, 3}));
  EXPECT_EQ(errors.near.within[2], 0u);
  EXPECT_EQ(distance_errors(truth, computed).far.within[2], 1u);
  EXPECT_DOUBLE_EQ(errors.far.largest(), errors.far.largest_over);
}

}  // namespace
}  // namespace geodrome::bench
