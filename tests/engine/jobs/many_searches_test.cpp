// SPDX-License-Identifier: MIT
// Matrices by a solver that prepares all of their rows together; `test_together` marks by a rounding what it made so.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>

#include "geodrome/engine/session.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/stops_at_rows.hpp"

namespace geodrome::testing {
namespace {

using nlohmann::json;

/// Keeps the log, and is cancelled by a line of it.
class Listener : public Observer {
 public:
  explicit Listener(std::string line = "") : line_(std::move(line)) {}

  void log(LogLevel, std::string_view message) override {
    const std::lock_guard lock(mutex_);
    heard_.append(message).append("\n");
    if (!line_.empty() && message.find(line_) != std::string_view::npos) stop_ = true;
  }
  bool cancelled() const noexcept override { return stop_; }
  bool heard(const std::string& words) const { return heard_.find(words) != std::string::npos; }

 private:
  std::string line_, heard_;
  std::mutex mutex_;
  std::atomic<bool> stop_ = false;
};

/// Two tori, one beside the other.
class ManySearchesJob : public ::testing::Test {
 protected:
  ManySearchesJob() { write_mesh(file_, *mesh_); }

  DistanceJob job(const std::string& solver = "test_together") const {
    DistanceJob job{.input = file_};
    job.settings.stages.solver = solver;
    job.settings.plugin_path = {GEODROME_BINARY_DIR "/tests/sound_plugins"};
    job.settings.threads = 2;
    job.matrix = matrix_;
    return job;
  }
  JobReport run(const DistanceJob& job, Observer& observer = silent_observer()) const {
    JobReport report = run_distances(job, observer);
    EXPECT_TRUE(report.broken_promises.empty()) << report.broken_promises.front();
    return report;
  }
  json matrix_of(const DistanceJob& job) const { return json::parse(run(job).json)["matrix"]; }
  std::string bytes() const { return read_bytes(matrix_); }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "m.ply", matrix_ = folder_ / "d.npy",
                              partial_ = folder_ / "d.npy.partial";
  const MeshPtr one_ = test::bumpy_torus(12, 8, 0.05, 2);
  const MeshPtr mesh_ = test::both(one_, test::mapped(one_, [](const Vec3& p) { return p + Vec3{0, 0, 9}; }));
};

TEST_F(ManySearchesJob, MakesAllRowsButTheFirstByWhatWasPrepared) {
  run(job("chen_han"));
  const Matrix plain = read_npy(matrix_);
  const json found = matrix_of(job());
  const Matrix planned = read_npy(matrix_);
  ASSERT_EQ(planned.rows, plain.rows);
  for (std::size_t i = 0; i < plain.rows; ++i) {
    std::size_t differ = 0;
    for (std::size_t j = 0; j < plain.columns; ++j) {
      differ += planned(i, j) != plain(i, j);
      EXPECT_TRUE(planned(i, j) == plain(i, j) || std::abs(planned(i, j) - plain(i, j)) < 1e-13) << i << ", " << j;
    }
    EXPECT_EQ(differ > 0, i > 0) << "row " << i;
  }
  EXPECT_EQ(found["counters"]["planned_searches"], plain.rows - 1);
}

TEST_F(ManySearchesJob, IsToldInTheReport) {
  Listener observer;
  const JobReport report = run(job(), observer);
  const json plan = json::parse(report.json)["matrix"]["many_searches"];
  EXPECT_EQ(plan["used"], true);
  EXPECT_EQ(plan["sources"], mesh_->vertex_count());
  EXPECT_GT(plan["bytes"], 1'000'000);
  EXPECT_GE(plan["seconds"], 0);
  EXPECT_EQ(plan["measures"]["planned_sources"], mesh_->vertex_count());
  EXPECT_EQ(plan["measures"]["planned_radius"], "inf");
  EXPECT_NE(report.summary.find("\nrows       prepared together: "), std::string::npos) << report.summary;
  EXPECT_TRUE(observer.heard("solver: a plan came"));
}

TEST_F(ManySearchesJob, MakesPlainRowsWhereItWouldNotPay) {
  run(job("chen_han"));
  const std::string plain = bytes();
  const JobReport report = run(job("test_together:answer=null"));
  EXPECT_EQ(bytes(), plain);
  const json plan = json::parse(report.json)["matrix"]["many_searches"];
  EXPECT_EQ(plan["used"], false);
  EXPECT_EQ(plan["bytes"], 0);
  EXPECT_EQ(plan["measures"]["planned_sources"], mesh_->vertex_count());
  EXPECT_EQ(report.summary.find("prepared together"), std::string::npos);
}

TEST_F(ManySearchesJob, DoesNotAskForOneRow) {
  DistanceJob one = job("test_together:answer=throws");
  one.sources = "5";
  EXPECT_FALSE(matrix_of(one).contains("many_searches"));
}

TEST_F(ManySearchesJob, DoesNotAskWhereSourcesHaveSurfacesOfTheirOwn) {
  write_points(folder_ / "t.xyz", test::torus(1000, 1).points);
  DistanceJob cloud = job("test_together:answer=throws");
  cloud.input = folder_ / "t.xyz", cloud.sources = "0,7,9", cloud.query = ProjectionRule::insert;
  EXPECT_FALSE(matrix_of(cloud).contains("many_searches"));
  cloud.query = ProjectionRule::project;
  EXPECT_THROW(run(cloud), RefusedError);
}

TEST_F(ManySearchesJob, TellsTheSolverOfSubsetsAndLimits) {
  DistanceJob some = job();
  some.sources = "0,30,70 + 0.5,30,5 0.2 0.3 0.5,8 + 3", some.targets = "3-40,100", some.max_distance = 1.5;
  const json plan = matrix_of(some)["many_searches"];
  EXPECT_EQ(plan["used"], true);
  EXPECT_EQ(plan["measures"]["planned_sources"], 4) << "one is named twice, one starts beyond the limit";
  EXPECT_EQ(plan["measures"]["planned_radius"], 1.5);
}

TEST_F(ManySearchesJob, GivesTheSameBytesForAnyNumberOfThreads) {
  DistanceJob all = job();
  all.settings.threads = 1;
  run(all);
  const std::string whole = bytes();
  all.settings.threads = 3;
  EXPECT_EQ(matrix_of(all)["counters"]["planned_searches"], mesh_->vertex_count() - 1);
  EXPECT_EQ(bytes(), whole);
}

TEST_F(ManySearchesJob, GivesTheSameBytesAfterAResumedRun) {
  for (const ScalarType scalar : {ScalarType::float64, ScalarType::float32}) {
    DistanceJob all = job();
    all.scalar = scalar, all.bounds = folder_ / "l.npy", all.max_distance = 2;
    run(all);
    const std::string whole = bytes(), bounds = read_bytes(all.bounds);
    test::StopsAtRows observer(0.3);
    EXPECT_THROW(run_distances(all, observer), Cancelled);
    all.resume = true;
    const json found = matrix_of(all);
    EXPECT_GT(found["resumed_rows"], 10);
    EXPECT_EQ(found["many_searches"]["measures"]["planned_sources"], mesh_->vertex_count()) << "not of what is missing";
    EXPECT_EQ(bytes(), whole);
    EXPECT_EQ(read_bytes(all.bounds), bounds);
  }
}

/// Sets of rows, from one process or several, take one preparation each.
TEST_F(ManySearchesJob, GivesTheBytesOfASessionWhichPreparesOnceForTheSameSources) {
  class Plans : public Observer {
   public:
    void log(LogLevel, std::string_view message) override { count += message == "solver: a plan came"; }
    std::atomic<int> count = 0;
  } plans;
  run(job());
  const std::vector<double> expected = read_npy(matrix_).values;
  const Session session(file_, job().settings, plans);
  const auto all = session.select("all"), some = session.select("3,5");
  EXPECT_EQ(session.distances(all, all), expected);
  std::vector<double> rows(expected.size(), -1);
  MatrixInMemory<double> sink(rows, all.size(), all.size());
  for (const std::uint64_t part : {2, 0, 1}) session.distances(all, all, sink, {}, RowSet::part(part, 3, all.size()));
  EXPECT_EQ(rows, expected);
  session.distances(all, all, sink);
  session.distances({&some[0], 1}, all);
  EXPECT_EQ(plans.count, 1);
  session.distances(some, all);
  EXPECT_EQ(plans.count, 2);
  session.distances(some, all, {.max_distance = 1});
  EXPECT_EQ(plans.count, 3);
}

TEST_F(ManySearchesJob, CancelledWhilePreparingLeavesWhatAResumedRunGoesOnWith) {
  DistanceJob waiting = job("test_together:answer=waits");
  for (const bool resume : {false, true}) {
    waiting.resume = resume;
    Listener observer("a plan came");
    EXPECT_THROW(run_distances(waiting, observer), Cancelled);
    EXPECT_TRUE(observer.heard("d.npy.partial holds 1 of " + std::to_string(mesh_->vertex_count()) + " rows"));
    EXPECT_TRUE(std::filesystem::exists(partial_));
  }
}

TEST_F(ManySearchesJob, TellsWhatWentWrongWhilePreparing) {
  try {
    run(job("test_together:answer=throws"));
    FAIL() << "was done";
  } catch (const RefusedError& error) {
    EXPECT_STREQ(error.what(), "solver_test_together: the plan is too large; make it smaller");
  }
  EXPECT_TRUE(std::filesystem::exists(partial_));
}

/// A version without the extension made other roundings.
TEST_F(ManySearchesJob, MarksItsPartialFiles) {
  const auto mark = [&](DistanceJob interrupted) {
    test::StopsAtRows observer(0.3);
    EXPECT_THROW(run_distances(interrupted, observer), Cancelled);
    return read_bytes(partial_).find("geodrome.many_searches/1") != std::string::npos;
  };
  EXPECT_TRUE(mark(job()));
  EXPECT_FALSE(mark(job("edge_dijkstra")));
}

}  // namespace
}  // namespace geodrome::testing
