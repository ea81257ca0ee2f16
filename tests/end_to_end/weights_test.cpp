// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/environment.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;
using namespace std::chrono_literals;

/// The unit square, cut from vertex 0 to vertex 2 into two faces of weights 0.5 and 4, in the file and beside it.
class Weights : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bytes(folder_ / "m.ply",
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                "element face 2\nproperty list uchar int vertex_indices\nproperty double weight\nend_header\n"
                "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 0.5\n3 0 2 3 4\n");
    write_bytes(folder_ / "w.txt", "0.5\n4\n");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// A command on the mesh with plugins for tests, and more arguments.
  Outcome run(const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{command, file("m.ply"), "--plugin-path",
                                       GEODROME_BINARY_DIR "/tests/sound_plugins"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_geodrome(folder_, arguments);
  }
  Outcome distances(const std::string& weights, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"--solver", "test_weighted", "--weights", weights,
                                       "-o",       file("d.npy"),   "--report",  file("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run("distances", arguments);
  }
  void expect(const Outcome& outcome, int status, const std::string& word) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Weights, OfAPropertyAndOfAFileGiveTheSameDistances) {
  for (const std::string& weights : {std::string("property:weight"), file("w.txt")}) {
    const Outcome outcome = distances(weights);
    ASSERT_EQ(outcome.status, 0) << outcome.err;  // D(0, 1) = 0.5 is below the straight line: no broken promise
    EXPECT_NE(outcome.out.find("0.5 to 4"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("smallest weight x Euclid"), std::string::npos) << outcome.out;
    const Matrix d = read_npy(folder_ / "d.npy");
    EXPECT_EQ(d(0, 1), 0.5);
    EXPECT_DOUBLE_EQ(d(0, 2), 0.5 * std::sqrt(2));  // the edge of both faces costs what the cheaper one does
    EXPECT_EQ(d(0, 3), 4);
  }
}

TEST_F(Weights, StandInTheReport) {
  ASSERT_EQ(distances(file("w.txt")).status, 0);
  const json weights = json::parse(read_bytes(folder_ / "r.json"))["input"]["weights"];
  EXPECT_EQ(weights["from"], file("w.txt"));
  EXPECT_EQ(weights["smallest"], 0.5);
  EXPECT_EQ(weights["largest"], 4);
  EXPECT_EQ(weights["hash"].get<std::string>().size(), 32u);
}

TEST_F(Weights, OfAPathCountInItsLength) {
  const Outcome outcome = run("path", {"--solver", "test_weighted", "--weights", "property:weight", "--from", "3",
                                       "--to", "1", "-o", file("p.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json path = json::parse(read_bytes(folder_ / "p.json"));
  EXPECT_DOUBLE_EQ(path["length"].get<double>(), 4.5);
  EXPECT_EQ(path["length"], path["distance"]);
}

TEST_F(Weights, AreComparedWithSolversThatHaveThem) {
  const Outcome outcome = run("compare", {"--stage", "solver=test_weighted", "--weights", "property:weight", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["combinations"][0]["errors"]["compared"], 3);
}

TEST_F(Weights, AreToldByCheck) {
  const Outcome outcome = run("check", {"--weights", "property:weight"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("weights    0.5 to 4, from property:weight"), std::string::npos) << outcome.out;
}

TEST_F(Weights, ThatNobodyAskedForAreToldOf) {
  expect(run("path", {"--from", "0", "--to", "3", "-o", file("p.obj")}), 0, "--weights property:weight");
  EXPECT_NE(run("check", {}).out.find("--weights property:weight"), std::string::npos);
}

TEST_F(Weights, AreKeptInTheSurfaceThatIsWritten) {
  ASSERT_EQ(run("surface", {"--weights", file("w.txt"), "-o", file("s.ply")}).status, 0);
  EXPECT_NE(read_bytes(folder_ / "s.ply").find("property double weight"), std::string::npos);
  expect(run("surface", {"--weights", file("w.txt"), "-o", file("s.off")}), 2, ".ply");
}

TEST_F(Weights, ThatASolverDoesNotProvideAreRefusedByName) {
  const Environment patience("GEODROME_VET_TIMEOUT", "5");  // one of the plugins tried for the remedy hangs
  const Outcome outcome =
      run("distances", {"--solver", "edge_dijkstra", "--weights", "property:weight", "-o", file("d.npy")});
  expect(outcome, 3, "solver_edge_dijkstra does not measure with weights");
  expect(outcome, 3, "test_weighted");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy"));
}

TEST_F(Weights, ThatAreBadAreRefused) {
  write_bytes(folder_ / "short.txt", "1\n");
  write_bytes(folder_ / "zero.txt", "1\n0\n");
  expect(distances(file("short.txt")), 3, "short.txt: holds 1 weight");
  expect(distances(file("zero.txt")), 3, "line 2");
  expect(distances("property:cost"), 3, "'weight'");
  expect(distances("property:weight", {"--as", "points"}), 3, "points");
  expect(distances(file("none.txt")), 3, "none.txt");
  expect(distances("property:"), 2, "property:NAME");
  expect(distances(""), 2, "--weights");
}

TEST_F(Weights, AreNotWrittenOver) {
  write_bytes(folder_ / "w.csv", "0.5\n4\n");
  expect(run("path", {"--solver", "test_weighted", "--weights", file("w.csv"), "--from", "0", "--to", "3", "-o",
                      file("w.csv")}),
         2, "read");
}

/// A job of some seconds that is killed once its rows are on disk.
TEST_F(Weights, ThatDifferAreAnotherRunWhichIsNotResumed) {
  run_geodrome(folder_, {"shape", "torus", "--mesh", "--faces", "4000", "-o", file("m.ply")});
  const std::size_t faces = json::parse(run("check", {"--json"}).out)["input"]["faces_in_file"];
  std::string ones;
  for (std::size_t f = 0; f < faces; ++f) ones += "1\n";
  write_bytes(folder_ / "w.txt", "2\n" + ones.substr(2));
  write_bytes(folder_ / "other.txt", "3\n" + ones.substr(2));
  const std::vector<std::string> job{"distances",
                                     file("m.ply"),
                                     "--plugin-path",
                                     GEODROME_BINARY_DIR "/tests/sound_plugins",
                                     "--solver",
                                     "test_weighted",
                                     "-o",
                                     file("d.npy"),
                                     "--weights"};
  const auto with = [&](const std::string& weights) {
    std::vector<std::string> arguments = job;
    arguments.insert(arguments.end(), {file(weights), "--resume"});
    return arguments;
  };
  RunningProgram first(folder_, "geodrome", with("w.txt"));
  for (int i = 0; i < 2500 && !std::filesystem::exists(folder_ / "d.npy.partial"); ++i)
    std::this_thread::sleep_for(2ms);
  std::this_thread::sleep_for(50ms);
  first.send(SIGKILL);
  first.wait();
  const Outcome resumed = run_geodrome(folder_, with("other.txt"));
  expect(resumed, 4, "weights was");
}

}  // namespace
