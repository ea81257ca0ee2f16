// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "geodrome/engine/session.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/samples.hpp"

namespace geodrome::testing {

inline double arc(const Vec3& p, const Vec3& q) { return std::atan2(norm(cross(p, q)), dot(p, q)); }

/// Jobs and sessions under the smooth metric, on points of the unit sphere; `test_sphere` knows what they are of.
class SmoothMetric : public ::testing::Test {
 protected:
  SmoothMetric() { write_points(file_, points_); }

  RunSettings settings(Metric metric = Metric::smooth, const std::string& tangent = "test_sphere") const {
    RunSettings settings{.metric = metric, .plugin_path = {GEODROME_BINARY_DIR "/tests/sound_plugins"}, .threads = 2};
    settings.stages.tangent = tangent;
    return settings;
  }
  DistanceJob job(Metric metric = Metric::smooth) const {
    return {.input = file_, .settings = settings(metric), .sources = "0:500:25", .matrix = matrix_};
  }
  JobReport run(const DistanceJob& job) const {
    JobReport report = run_distances(job, silent_observer());
    EXPECT_TRUE(report.broken_promises.empty()) << report.broken_promises.front();
    return report;
  }
  Matrix made(const DistanceJob& job) const {
    run(job);
    return read_npy(matrix_);
  }

  /// Mean relative error of the distances of points at least 0.7 apart.
  double error(const Matrix& matrix) const {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < matrix.rows; ++i)
      for (std::size_t j = 0; j < matrix.columns; ++j)
        if (const double truth = arc(points_[25 * i], points_[j]); truth > 0.7 && truth < 3)
          sum += std::abs(matrix(i, j) / truth - 1), ++count;
    return sum / count;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "s.xyz", matrix_ = folder_ / "d.npy";
  const std::vector<Vec3> points_ = test::sphere(500, 1).points;
};

}  // namespace geodrome::testing
