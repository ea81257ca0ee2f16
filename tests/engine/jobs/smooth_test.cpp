// SPDX-License-Identifier: MIT
// Matrices under the smooth metric.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/engine/jobs/smooth_fixture.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/same_bytes.hpp"
#include "tests/support/stops_at_rows.hpp"
#include "tools/shapes/meshes.hpp"

namespace geodrome::testing {
namespace {

using nlohmann::json;
using test::same_bytes;

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
  pairs.index = folder_ / "p.index";
  EXPECT_THROW(run_pairs(pairs, silent_observer()), OptionError);
  pairs.index.clear(), pairs.settings.stages.solver = "heat";
  EXPECT_THROW(run_pairs(pairs, silent_observer()), CapabilityError);
}

}  // namespace
}  // namespace geodrome::testing
