// SPDX-License-Identifier: MIT
// The head of the jobs: what is wrong with lists, plugins and what they provide is told before stage 1 runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>

#include "geodrome/engine/jobs.hpp"
#include "tests/support/program.hpp"
#include "tests/support/samples.hpp"

namespace geodrome::testing {
namespace {

/// Keeps which stages ran.
class StageRecorder final : public Observer {
 public:
  void progress(std::string_view stage, double) override { add(stage); }

  bool saw(const std::string& stage) const { return std::ranges::find(stages_, stage) != stages_.end(); }
  const std::vector<std::string>& stages() const { return stages_; }

 private:
  void add(std::string_view stage) {
    const std::lock_guard lock(mutex_);
    if (!saw(std::string(stage))) stages_.emplace_back(stage);
  }

  std::mutex mutex_;
  std::vector<std::string> stages_;
};

class JobHeads : public ::testing::Test {
 protected:
  JobHeads() {
    test::Random random(7);
    std::string points;
    for (int i = 0; i < 200; ++i) {  // a sphere
      const Vec3 p = random.direction();
      points += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    write_bytes(folder_ / "s.xyz", points);
    write_bytes(folder_ / "p.txt", "0, 1\n2, 3\n");
    settings_.threads = 1;
  }

  RunSettings with_solver(const std::string& solver) const {
    RunSettings settings = settings_;
    settings.stages.solver = solver;
    return settings;
  }
  DistanceJob distances(const std::string& solver) const {
    return {.input = folder_ / "s.xyz", .settings = with_solver(solver), .sources = "0", .matrix = folder_ / "d.npy"};
  }
  PathJob path(const std::string& solver) const {
    return {.input = folder_ / "s.xyz", .settings = with_solver(solver), .from = "0", .to = "1"};
  }
  PairJob pairs(const std::string& solver) const {
    return {.input = folder_ / "s.xyz",
            .settings = with_solver(solver),
            .pairs = folder_ / "p.txt",
            .out = folder_ / "q.npy"};
  }

  /// The error of a job, which must come before any stage runs and contain `part`.
  template <class Kind, class Run>
  void expect_early(Run&& run, const std::string& part) const {
    StageRecorder recorder;
    try {
      run(recorder);
      ADD_FAILURE() << "was accepted";
    } catch (const Kind& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_EQ(recorder.stages(), std::vector<std::string>{}) << part;
  }

  const TemporaryFolder folder_;
  RunSettings settings_;
};

TEST_F(JobHeads, ASoundJobRunsItsStages) {  // so that the others can fail
  StageRecorder recorder;
  run_distances(distances("chen_han"), recorder);
  EXPECT_TRUE(recorder.saw("tangent"));
  EXPECT_TRUE(recorder.saw("reconstructor"));
}

TEST_F(JobHeads, TellOfAnUnknownSolverBeforeStage1) {
  expect_early<OptionError>([&](Observer& o) { run_distances(distances("chen_hun"), o); }, "chen_hun");
  expect_early<OptionError>([&](Observer& o) { run_path(path("chen_hun"), o); }, "chen_hun");
  expect_early<OptionError>([&](Observer& o) { run_pairs(pairs("chen_hun"), o); }, "chen_hun");
}

TEST_F(JobHeads, TellOfAnUnknownSampleStageBeforeStage1) {
  DistanceJob job = distances("chen_han");
  job.settings.stages.reconstructor = "delaunay_cat";
  expect_early<OptionError>([&](Observer& o) { run_distances(job, o); }, "delaunay_cat");
}

TEST_F(JobHeads, TellOfWhatTheSolverLacksBeforeStage1) {
  DistanceJob job = distances("heat");
  job.max_distance = 1;
  expect_early<CapabilityError>([&](Observer& o) { run_distances(job, o); }, "radius_limit");
  expect_early<CapabilityError>([&](Observer& o) { run_path(path("heat"), o); }, "paths");
  expect_early<CapabilityError>([&](Observer& o) { run_pairs(pairs("heat"), o); }, "pair_queries");

  write_bytes(folder_ / "starts.txt", "0 + 0.5\n1\n");
  DistanceJob nearest = distances("heat");
  nearest.sources = "@" + (folder_ / "starts.txt").string(), nearest.nearest = folder_ / "n.csv";
  expect_early<CapabilityError>([&](Observer& o) { run_distances(nearest, o); }, "start_distances");
}

TEST_F(JobHeads, TellOfListsThatCannotBeReadBeforeStage1) {
  DistanceJob job = distances("chen_han");
  job.targets = "0,x";
  expect_early<OptionError>([&](Observer& o) { run_distances(job, o); }, "'x'");
  PathJob ends = path("chen_han");
  ends.to = "0,1";
  expect_early<OptionError>([&](Observer& o) { run_path(ends, o); }, "2 points");
  write_bytes(folder_ / "p.txt", "0, 1\n2\n");
  expect_early<InputError>([&](Observer& o) { run_pairs(pairs("aleksandrov"), o); }, "line 2");
}

TEST_F(JobHeads, CompareTellsOfASolverInItsRowBeforeStage1) {
  CompareJob job{.input = folder_ / "s.xyz", .settings = with_solver("chen_hun")};
  StageRecorder recorder;
  const CompareReport report = run_compare(job, recorder);
  EXPECT_EQ(report.error_status, 2);
  EXPECT_NE(report.json.find("chen_hun"), std::string::npos);
  EXPECT_FALSE(recorder.saw("tangent"));

  job.settings = settings_, job.sources = "0,x";
  expect_early<OptionError>([&](Observer& o) { run_compare(job, o); }, "'x'");
  job.sources = "0", job.truth = "exact:chen_hun";
  expect_early<OptionError>([&](Observer& o) { run_compare(job, o); }, "chen_hun");
}

TEST_F(JobHeads, ARefusedSampleIsReportedAndThrown) {
  std::string line;
  for (int i = 0; i < 200; ++i) line += std::to_string(0.01 * i) + " 0 0\n";
  write_bytes(folder_ / "s.xyz", line);
  DistanceJob job = distances("chen_han");
  job.report = folder_ / "r.json";
  Observer silent;
  EXPECT_THROW(run_distances(job, silent), SampleError);
  EXPECT_NE(read_bytes(folder_ / "r.json").find("\"refused\""), std::string::npos);
}

}  // namespace
}  // namespace geodrome::testing
