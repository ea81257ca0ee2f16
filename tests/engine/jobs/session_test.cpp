// SPDX-License-Identifier: MIT
// Distances in memory: the same bytes as the jobs' files, whichever way the input came and however many threads ask.
#include "geodrome/engine/session.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/support/meshes.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/same_bytes.hpp"
#include "tests/support/samples.hpp"

namespace geodrome::testing {
namespace {

using geodrome::test::same_bytes;

const std::string pair_plugins = std::string(GEODROME_BINARY_DIR) + "/tests/sound_plugins";

std::vector<Index> first_rows(Index count) {
  std::vector<Index> rows;
  for (Index i = 0; i < count; ++i) rows.push_back(i);
  return rows;
}

/// A torus as a file and as arrays, and what the jobs write of it.
class Sessions : public ::testing::Test {
 protected:
  Sessions() {
    write_mesh(file_, *mesh_);
    settings_.threads = 3;
  }
  Arrays arrays() const { return {.positions = mesh_->positions(), .faces = mesh_->triangles()}; }
  Session in_memory() const { return Session(make_input(arrays()), settings_); }
  Matrix job_matrix(DistanceJob job) const {
    job.settings = settings_, job.matrix = folder_ / "d.npy";
    run_distances(job, silent_observer());
    return read_npy(folder_ / "d.npy");
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "m.ply";
  const MeshPtr mesh_ = test::bumpy_torus(12, 8, 0.05, 2);
  RunSettings settings_;
};

TEST_F(Sessions, FromFileAndArraysGiveTheJobsMatrix) {
  const Matrix expected = job_matrix({.input = file_});
  for (const Session& session : {Session(file_, settings_), in_memory()}) {
    const auto all = session.select("all");
    EXPECT_TRUE(same_bytes(session.distances(all, all), expected.values));
  }
}

TEST_F(Sessions, GiveTheSameRowsToSeveralThreadsAtOnce) {
  const Session session = in_memory();
  const auto all = session.select("all");
  const std::vector<double> expected = session.distances(all, all);
  std::atomic<int> equal = 0;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&] {
        const auto own = session.select(first_rows(20));
        const std::vector<double> rows = session.distances(own, all);
        equal += same_bytes(rows, std::span(expected).first(rows.size()));
      });
  }
  EXPECT_EQ(equal, 4);
}

TEST_F(Sessions, PrepareOnceForManyThreads) {
  const Session session = in_memory();
  std::vector<double> found(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < found.size(); ++t)
      threads.emplace_back([&, t] {
        const auto ends = session.select("0,9");
        found[t] = session.path(ends[0], ends[1]).distance;
      });
  }
  EXPECT_GT(found[0], 0);
  for (const double distance : found) EXPECT_EQ(distance, found[0]);
}

TEST_F(Sessions, WriteIntoTheCallersMemoryAndIntoSinks) {
  const Session session = in_memory();
  const auto all = session.select("all"), some = session.select("3,5");
  const std::vector<double> expected = session.distances(some, all);
  std::vector<double> out(expected.size(), -1);
  session.distances(some, all, out);
  EXPECT_TRUE(same_bytes(out, expected));
  EXPECT_THROW(session.distances(some, all, std::span(out).first(7)), OptionError);

  std::vector<double> rows(expected.size(), -1);
  MatrixInMemory<double> sink(rows, 2, all.size());
  session.distances(some, all, sink, {}, RowSet::range(1, 2));
  EXPECT_FALSE(sink.has(0));
  EXPECT_TRUE(same_bytes(std::span(rows).subspan(all.size()), std::span(expected).subspan(all.size())));
  session.distances(some, all, sink);
  EXPECT_TRUE(same_bytes(rows, expected));
  EXPECT_THROW(session.distances(some, all, sink, {}, RowSet::range(1, 3)), OptionError) << "there are two sources";
}

TEST_F(Sessions, ObeyLimitsAndStartDistances) {
  write_bytes(folder_ / "s.txt", "3 + 0.25\n7\n");
  const std::string list = "@" + (folder_ / "s.txt").string();
  const Matrix expected = job_matrix({.input = file_, .sources = list, .max_distance = 1.5});
  const Session session = in_memory();
  const auto found = session.distances(session.select(list), session.select("all"), {.max_distance = 1.5});
  EXPECT_TRUE(same_bytes(found, expected.values));
  EXPECT_THROW(session.distances({}, {}, {.max_distance = -1}), OptionError);
  auto wrong = session.select("3");
  for (const double start : {-1.0, double{INFINITY}, double{NAN}}) {
    wrong[0].start = start;
    EXPECT_THROW(session.distances(wrong, wrong), OptionError) << start;
    EXPECT_THROW(session.nearest(wrong, wrong), OptionError) << start;
  }
}

TEST_F(Sessions, GiveTheNearestSource) {
  const Session session = in_memory();
  const auto all = session.select("all"), sources = session.select("0,40");
  const std::vector<double> rows = session.distances(sources, all);
  const std::vector<Distance> nearest = session.nearest(sources, all);
  ASSERT_EQ(nearest.size(), all.size());
  for (std::size_t j = 0; j < all.size(); ++j) {
    const double first = rows[j], second = rows[all.size() + j];
    EXPECT_NEAR(nearest[j].value, std::min(first, second), 1e-12);
    if (std::abs(first - second) > 1e-9) EXPECT_EQ(nearest[j].source, first < second ? 0u : 1u);
  }
}

TEST_F(Sessions, GiveTheJobsPaths) {
  const PathResult expected =
      run_path({.input = file_, .settings = settings_, .from = "0", .to = "33"}, silent_observer());
  const Session session = in_memory();
  const auto ends = session.select("0,33");
  const PathResult path = session.path(ends[0], ends[1]);
  EXPECT_EQ(path.distance, expected.distance);
  EXPECT_EQ(path.length, expected.length);
  EXPECT_EQ(path.points, expected.points);
  EXPECT_EQ(path.positions, expected.positions);
}

TEST_F(Sessions, GiveTheJobsPairs) {
  settings_.stages.solver = "test_pairs", settings_.plugin_path = {pair_plugins};
  write_bytes(folder_ / "p.txt", "3, 17\n12 0.2 0.3 0.5, 4\n9, 9\n");
  run_pairs({.input = file_, .settings = settings_, .pairs = folder_ / "p.txt", .out = folder_ / "q.npy"},
            silent_observer());
  const Session session = in_memory();
  const PairList list = select_pairs(folder_ / "p.txt", session.input(), session.surface());
  EXPECT_TRUE(same_bytes(session.pairs(list.pairs), read_npy(folder_ / "q.npy").values));
  std::vector<NamedPair> with_start = list.pairs;
  with_start[1].from.start = 0.5;
  EXPECT_THROW(session.pairs(with_start), OptionError);
  EXPECT_THROW(Session(file_).pairs(list.pairs), CapabilityError) << "chen_han has no oracle";
}

TEST_F(Sessions, SelectRowsPointsAndPositions) {
  const Session session = in_memory();
  const std::vector<Index> rows{4, 2};
  EXPECT_EQ(session.select(rows)[1].row, 2u);
  const std::vector<Index> beyond{4, 2000};
  EXPECT_THROW(session.select(beyond), OptionError);
  const std::vector<SurfacePoint> inside{{5, {0.2, 0.3, 0.5}}};
  EXPECT_EQ(session.select(inside)[0].place.at, inside[0]);
  const std::vector<SurfacePoint> nowhere{{100000, {1, 0, 0}}}, unbalanced{{0, {1, 1, 0}}};
  EXPECT_THROW(session.select(nowhere), OptionError);
  EXPECT_THROW(session.select(unbalanced), OptionError);
  const std::vector<Vec3> positions{mesh_->positions()[7]};
  EXPECT_EQ(session.select(positions)[0].place.vertex, 7u);
  const std::vector<Vec3> infinite{{INFINITY, 0, 0}};
  EXPECT_THROW(session.select(infinite), OptionError);
}

/// Keeps the warnings.
class WarningRecorder final : public Observer {
 public:
  void log(LogLevel level, std::string_view message) override {
    if (level == LogLevel::warning) warnings.emplace_back(message);
  }
  std::vector<std::string> warnings;
};

TEST_F(Sessions, TellPointsOffTheSurface) {
  WarningRecorder observer;
  const Session session(make_input(arrays()), settings_, observer);
  const std::vector<Vec3> near{mesh_->positions()[7]}, far{{100, 0, 0}, mesh_->positions()[3]};
  EXPECT_EQ(session.select(near)[0].off_surface, 0);
  EXPECT_TRUE(observer.warnings.empty());
  const std::vector<NamedPoint> named = session.select(far);
  EXPECT_GT(named[0].off_surface, 90);
  EXPECT_EQ(named[1].off_surface, 0);
  ASSERT_EQ(observer.warnings.size(), 1u);
  EXPECT_NE(observer.warnings[0].find("'positions[0]' by 9"), std::string::npos) << observer.warnings[0];
  const PathResult path = session.path(named[1], named[0]);
  EXPECT_EQ(path.from_off_surface, 0);
  EXPECT_EQ(path.to_off_surface, named[0].off_surface);
}

TEST_F(Sessions, RefuseNumbersBeyondTheRangeOfInputs) {
  const Session session = in_memory();
  const std::vector<Vec3> beyond{{0, 1e200, 0}};
  EXPECT_THROW(session.select(beyond), OptionError);
  auto late = session.select("3");
  late[0].start = std::numeric_limits<double>::max();
  EXPECT_THROW(session.nearest(late, session.select("all")), OptionError);
}

TEST_F(Sessions, ReportOfTheSurface) {
  const Session session = in_memory();
  const SurfaceReport report = session.surface_report();
  EXPECT_EQ(report.facts.vertices, mesh_->vertex_count());
  EXPECT_EQ(report.facts.genus, 1);
  EXPECT_TRUE(report.facts.closed);
  EXPECT_TRUE(report.practice.empty());
  EXPECT_EQ(nlohmann::json::parse(report.json)["surface"]["genus"], 1);
  EXPECT_EQ(Session(file_).check().json, run_check({.input = file_}, silent_observer()).json);
  EXPECT_NE(session.check().text.find("genus 1"), std::string::npos);
  EXPECT_EQ(session.solver().full_name(), "solver_chen_han");
  EXPECT_EQ(session.factor(), 1);
}

class AfterFirstProgress final : public Observer {
 public:
  void progress(std::string_view stage, double) override {
    if (stage == "distances") stop_ = true;
  }
  bool cancelled() const noexcept override { return stop_; }

 private:
  std::atomic<bool> stop_ = false;
};

TEST_F(Sessions, CanBeCancelled) {
  AfterFirstProgress observer;
  const Session session(make_input(arrays()), settings_, observer);
  const auto all = session.select("all");
  EXPECT_THROW(session.distances(all, all), Cancelled);
}

TEST_F(Sessions, TellWhatIsWrongBeforeTheInputIsRead) {
  RunSettings settings = settings_;
  settings.stages.solver = "chen_hun";
  EXPECT_THROW(Session("missing.ply", settings), OptionError);
  settings.stages.solver = "heat";
  EXPECT_THROW(Session("missing.ply", settings, silent_observer(), Provides::paths), CapabilityError);
  EXPECT_THROW(Session("missing.ply", settings), InputError);
}

TEST_F(Sessions, OfPointsInMemoryGiveTheJobsMatrix) {
  test::Random random(11);
  std::vector<Vec3> points;
  for (int i = 0; i < 150; ++i) points.push_back(random.direction());
  write_points(folder_ / "s.ply", points);
  const Matrix expected = job_matrix({.input = folder_ / "s.ply", .sources = "0,1,2"});
  const Session session(make_input({.positions = points}), settings_);
  const auto found = session.distances(session.select("0,1,2"), session.select("all"));
  EXPECT_TRUE(same_bytes(found, expected.values));
  EXPECT_FALSE(session.surface_report().practice.empty());
  const auto ends = session.select("0,1");
  EXPECT_GE(session.path(ends[0], ends[1]).distance, distance(points[0], points[1]));

  const Matrix inserted = job_matrix({.input = folder_ / "s.ply", .sources = "0,1,2", .query = ProjectionRule::insert});
  const auto rows = session.distances(session.select("0,1,2"), session.select("all"), {.rule = ProjectionRule::insert});
  EXPECT_TRUE(same_bytes(rows, inserted.values));
}

TEST_F(Sessions, ThrowTheRefusalOfASample) {
  std::vector<Vec3> line;
  for (int i = 0; i < 100; ++i) line.push_back({0.01 * i, 0, 0});
  EXPECT_THROW(Session(make_input({.positions = line}), settings_), SampleError);
}

}  // namespace
}  // namespace geodrome::testing
