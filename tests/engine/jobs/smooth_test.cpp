// SPDX-License-Identifier: MIT
// Jobs and sessions under the smooth metric, on points of the unit sphere; `test_sphere` knows what they are of.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geodrome/engine/session.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/same_bytes.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/stops_at_rows.hpp"
#include "tools/shapes/meshes.hpp"

namespace geodrome::testing {
namespace {

using nlohmann::json;
using test::same_bytes;

double arc(const Vec3& p, const Vec3& q) { return std::atan2(norm(cross(p, q)), dot(p, q)); }

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

TEST_F(SmoothMetric, IsAHundredTimesAsAccurateAsTheFlatOne) {
  const double flat = error(made(job(Metric::flat))), smooth = error(made(job()));
  EXPECT_GT(flat, 1e-3);
  EXPECT_LT(smooth, 1e-2 * flat);
}

TEST_F(SmoothMetric, IsToldInReportAndSummary) {
  const JobReport report = run(job());
  const json found = json::parse(report.json);
  EXPECT_EQ(found["geodrome"]["metric"], "smooth");
  EXPECT_NE(found["geodrome"]["metric_caveat"].get<std::string>().find("no upper bound"), std::string::npos);
  EXPECT_EQ(found["smooth_surface"]["trusted_faces"], found["surface"]["faces"]);
  const json smooth = found["matrix"]["smooth"];
  EXPECT_EQ(smooth["paths"], 20 * 500 - 20);
  EXPECT_NEAR(smooth["share_of_length"].get<double>(), 1, 1e-12);
  EXPECT_GT(smooth["largest_correction"], smooth["mean_correction"]);
  EXPECT_LT(smooth["mean_estimated_error"], 1e-4);
  EXPECT_EQ(found["audit"]["audited"], true);
  EXPECT_EQ(found["matrix"]["invariants"]["symmetry"]["promised"], true);
  EXPECT_NE(report.summary.find("\nsmooth     100 % of the length, by tangent_test_sphere"), std::string::npos)
      << report.summary;
  EXPECT_FALSE(json::parse(run(job(Metric::flat)).json)["geodrome"].contains("metric"));
}

TEST_F(SmoothMetric, GivesTheSameBytesForAnyNumberOfThreadsAndAfterAnInterruption) {
  DistanceJob smooth = job();
  smooth.settings.threads = 1;
  const Matrix one = made(smooth);
  smooth.settings.threads = 3;
  EXPECT_TRUE(same_bytes(made(smooth).values, one.values));
  test::StopsAtRows stops(0.4);
  EXPECT_THROW(run_distances(smooth, stops), Cancelled);
  smooth.resume = true;
  const JobReport report = run(smooth);
  EXPECT_TRUE(same_bytes(read_npy(matrix_).values, one.values));
  EXPECT_EQ(json::parse(report.json)["matrix"]["invariants"]["symmetry"]["promised"], false)
      << "what the rows of the first run were changed by is not known";
}

TEST_F(SmoothMetric, DoesNotGoOnWithAFlatMatrix) {
  test::StopsAtRows stops(0.4);
  DistanceJob flat = job(Metric::flat);
  EXPECT_THROW(run_distances(flat, stops), Cancelled);
  DistanceJob smooth = job();
  smooth.resume = true;
  EXPECT_THROW(run(smooth), RefusedError);
}

TEST_F(SmoothMetric, IsThatOfSessionsToo) {
  DistanceJob some = job();
  some.sources = "0,7,9";
  const Matrix matrix = made(some);
  const Session session(file_, settings());
  const auto sources = session.select(some.sources), all = session.select("all");
  EXPECT_TRUE(same_bytes(session.distances(sources, all), matrix.values));
  EXPECT_THROW(session.bounded_distances(sources, all), OptionError);
  EXPECT_THROW(session.distances(sources, all, {.rule = ProjectionRule::insert}), OptionError);
}

TEST_F(SmoothMetric, HasThePathsOfItsDistances) {
  DistanceJob some = job();
  some.sources = "7";
  const Matrix matrix = made(some);
  const Session session(file_, settings());
  for (const Index to : {7u, 8u, 100u, 499u}) {
    const auto ends = session.select(std::vector<Index>{7, to});
    const PathResult path = session.path(ends[0], ends[1]);
    EXPECT_NEAR(path.distance, matrix(0, to), 1e-14);
    EXPECT_EQ(session.audit_path(ends[0], ends[1], path), std::vector<std::string>{});
    ASSERT_EQ(path.points.size(), path.positions.size());
    if (to == 7) continue;
    for (const Vec3& p : path.positions) EXPECT_NEAR(norm(p), 1, 1e-14);
    PathResult wrong = path;
    wrong.length *= 1 + 1e-12, wrong.distance *= 1 + 1e-12;
    EXPECT_EQ(session.audit_path(ends[0], ends[1], wrong).size(), 1u);
  }
  PathJob job{.input = file_, .settings = settings(), .from = "7", .to = "100", .out = folder_ / "p.csv"};
  EXPECT_NEAR(run_path(job, silent_observer()).distance, matrix(0, 100), 1e-14);
}

TEST_F(SmoothMetric, MeasuresTheNearestOnTheTriangles) {
  const Session session(file_, settings());
  const auto sources = session.select("0,7 + 0.2,9"), all = session.select("all");
  const std::vector<double> rows = session.distances(sources, all);
  std::vector<Distance> nearest = session.nearest(sources, all, 1.5);
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (nearest[j].reach == Reach::reached)
      EXPECT_NEAR(nearest[j].value, rows[nearest[j].source * all.size() + j], 1e-13);
    else
      EXPECT_GT(std::min({rows[j], rows[j + all.size()], rows[j + 2 * all.size()]}), 1.5 * 0.999);
  }
  EXPECT_EQ(session.audit_nearest(sources, all, nearest, 1.5), std::vector<std::string>{});
  nearest[3].value *= 1 + 1e-12;
  EXPECT_EQ(session.audit_nearest(sources, all, nearest, 1.5).size(), 1u);
  DistanceJob job{.input = file_, .settings = settings(), .sources = "0,7,9", .nearest = folder_ / "n.csv"};
  EXPECT_TRUE(json::parse(run(job).json)["nearest"].contains("smooth"));
}

TEST_F(SmoothMetric, HoldsTheLimitAgainstSmoothDistances) {
  DistanceJob all = job(), near = job();
  const Matrix whole = made(all);
  near.max_distance = 1;
  const Matrix limited = made(near);
  for (std::size_t k = 0; k < whole.values.size(); ++k)
    EXPECT_EQ(limited.values[k], whole.values[k] > 1 ? infinity : whole.values[k]);
}

TEST_F(SmoothMetric, StaysFlatWhereTheSurfaceIsNotTrusted) {
  DistanceJob smooth = job();
  smooth.settings.stages.tangent = "test_sphere:trusted=0";
  const json found = json::parse(run(smooth).json);
  EXPECT_NEAR(found["matrix"]["smooth"]["share_of_length"].get<double>(), 0.5, 0.1);
  const double half = error(read_npy(matrix_));
  EXPECT_LT(half, error(made(job(Metric::flat))));
  smooth.settings.stages.tangent = "test_sphere:trusted=-2";
  EXPECT_TRUE(same_bytes(made(smooth).values, made(job(Metric::flat)).values) ||
              std::abs(error(made(smooth)) / error(made(job(Metric::flat))) - 1) < 1e-12)
      << "sums of the same pieces, rounded in another order";
}

TEST_F(SmoothMetric, OfAMeshIsFittedToItsVertices) {
  const auto mesh = std::make_shared<const SurfaceMesh>(shapes::icosphere(320));
  write_mesh(folder_ / "m.ply", *mesh);
  DistanceJob smooth{.input = folder_ / "m.ply", .settings = settings(), .sources = "0", .matrix = matrix_};
  const Matrix matrix = made(smooth);
  for (Index v = 1; v < mesh->vertex_count(); ++v)
    EXPECT_NEAR(matrix(0, v), arc(mesh->positions()[0], mesh->positions()[v]), 1e-5);
}

TEST_F(SmoothMetric, RefusesWhatItDoesNotGoWith) {
  const auto refused = [&](auto&& change, const std::string& code) {
    DistanceJob wrong = job();
    change(wrong);
    try {
      run_distances(wrong, silent_observer());
      ADD_FAILURE() << "was not refused: " << code;
    } catch (const Error& error) {
      EXPECT_EQ(error.coded_remedy().code, code) << error.what();
    }
  };
  refused([](DistanceJob& job) { job.settings.stages.tangent = "pca"; }, "metric.flat_or_estimator");
  refused([](DistanceJob& job) { job.query = ProjectionRule::insert; }, "query.project_or");
  refused([&](DistanceJob& job) { job.bounds = folder_ / "b.npy"; }, "metric.flat");
  refused([](DistanceJob& job) { job.settings.stages.solver = "fast_marching"; }, "solver.provides");
  refused(
      [&](DistanceJob& job) {
        job.input = folder_ / "w.ply";
        const auto mesh = shapes::icosphere(20);
        write_mesh(job.input, SurfaceMesh({mesh.positions().begin(), mesh.positions().end()},
                                          {mesh.triangles().begin(), mesh.triangles().end()},
                                          std::vector<double>(mesh.face_count(), 2)));
        job.settings.read.weights = "property:weight";
      },
      "metric.flat");
  PairJob pairs{.input = file_, .settings = settings(), .pairs = folder_ / "p.txt", .out = folder_ / "p.csv"};
  EXPECT_THROW(run_pairs(pairs, silent_observer()), OptionError);
}

}  // namespace
}  // namespace geodrome::testing
