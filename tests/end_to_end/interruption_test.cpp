// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using namespace std::chrono_literals;

/// A job of some seconds on one thread, so that it can be interrupted.
class Interruption : public ::testing::Test {
 protected:
  void SetUp() override {
    const Outcome made = run_geodrome(folder_, {"shape", "jittered-torus", "--mesh", "--faces", "4000", "-o", mesh()});
    ASSERT_EQ(made.status, 0) << made.err;
    ASSERT_EQ(run_geodrome(folder_, job("whole.npy")).status, 0);
  }
  std::string mesh() const { return (folder_ / "t.ply").string(); }
  std::vector<std::string> job(const std::string& out) const {
    return {"distances", mesh(),    "-o", (folder_ / out).string(), "--solver", "edge_dijkstra", "--threads",
            "1",         "--audit", "0"};
  }
  /// Starts the job and signals it once some rows are there.
  Outcome interrupt(const std::vector<std::string>& arguments, int signal, std::chrono::milliseconds after) {
    RunningProgram program(folder_, "geodrome", arguments);
    const auto partial = folder_ / "d.npy.partial";
    for (int i = 0; i < 500 && !std::filesystem::exists(partial); ++i) std::this_thread::sleep_for(2ms);
    std::this_thread::sleep_for(after);
    program.send(signal);
    return program.wait();
  }
  /// The same for a new job, again if it was done before the signal came, as may be on a busy machine.
  Outcome interrupt_in_time(const std::vector<std::string>& arguments, int signal) {
    Outcome outcome = interrupt(arguments, signal, 10ms);
    for (int tries = 1; outcome.status == 0 && tries < 20; ++tries) {
      for (const char* name : {"d.npy", "r.json", "s.ply"}) std::filesystem::remove(folder_ / name);
      outcome = interrupt(arguments, signal, 0ms);
    }
    return outcome;
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  TemporaryFolder folder_;
};

TEST_F(Interruption, KilledJobsResumeToTheSameBytes) {
  std::vector<std::string> resumed = job("d.npy");
  resumed.push_back("--resume");
  for (const auto after : {5ms, 60ms, 20ms}) interrupt(resumed, SIGKILL, after);
  const Outcome last = run_geodrome(folder_, resumed);
  ASSERT_EQ(last.status, 0) << last.err;
  EXPECT_TRUE(read_bytes(folder_ / "d.npy") == read_bytes(folder_ / "whole.npy"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy.partial"));
}

/// Killed while the lists are made, and while rows are made of them, by one thread and by several.
TEST_F(Interruption, KilledJobsByRowListsResumeToTheSameBytes) {
  const std::string rough = (folder_ / "rough.ply").string();
  const Outcome made = run_geodrome(folder_, {"shape", "noisy-sphere", "--mesh", "--faces", "2500", "-o", rough});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto listed = [&](const std::string& out, const std::string& bounds, const char* threads) {
    return std::vector<std::string>{"distances",
                                    rough,
                                    "-o",
                                    (folder_ / out).string(),
                                    "--bounds",
                                    (folder_ / bounds).string(),
                                    "--solver",
                                    "chen_han:rows=lists",
                                    "--threads",
                                    threads,
                                    "--max-distance",
                                    "1.5",
                                    "--resume"};
  };
  const Outcome whole = run_geodrome(folder_, listed("rows.npy", "below.npy", "1"));
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_NE(whole.err.find("solver: rows by "), std::string::npos) << whole.err;
  for (const auto after : {5ms, 300ms, 500ms}) interrupt(listed("d.npy", "l.npy", "2"), SIGKILL, after);
  const Outcome last = run_geodrome(folder_, listed("d.npy", "l.npy", "4"));
  ASSERT_EQ(last.status, 0) << last.err;
  EXPECT_TRUE(read_bytes(folder_ / "d.npy") == read_bytes(folder_ / "rows.npy"));
  EXPECT_TRUE(read_bytes(folder_ / "l.npy") == read_bytes(folder_ / "below.npy"));
}

TEST_F(Interruption, CtrlCEndsWith130AndLeavesThePartialAndNothingElse) {
  std::vector<std::string> arguments = job("d.npy");
  arguments.insert(arguments.end(),
                   {"--report", (folder_ / "r.json").string(), "--surface", (folder_ / "s.ply").string()});
  const Outcome outcome = interrupt_in_time(arguments, SIGINT);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"d.npy.partial", "stderr", "stdout", "t.ply", "whole.npy"}));
}

TEST_F(Interruption, WhatAnEarlierRunLeftIsNotOverwrittenInSilence) {
  interrupt_in_time(job("d.npy"), SIGKILL);
  const Outcome anew = run_geodrome(folder_, job("d.npy"));
  EXPECT_EQ(anew.status, 0) << anew.err;
  EXPECT_NE(anew.err.find("d.npy.partial, which an earlier run left, is overwritten; otherwise --resume goes on with "),
            std::string::npos)
      << anew.err;
  const Outcome again = run_geodrome(folder_, job("d.npy"));
  EXPECT_EQ(again.err.find("overwritten"), std::string::npos) << again.err;
}

TEST_F(Interruption, CtrlCWhileAllRowsArePreparedTogetherLeavesThePartial) {
  std::vector<std::string> waiting{"distances",
                                   mesh(),
                                   "-o",
                                   (folder_ / "d.npy").string(),
                                   "--solver",
                                   "test_together:answer=waits",
                                   "--plugin-path",
                                   GEODROME_BINARY_DIR "/tests/sound_plugins"};
  const Outcome first = interrupt(waiting, SIGINT, 50ms);
  EXPECT_EQ(first.status, 130) << first.err;
  EXPECT_NE(first.err.find("d.npy.partial holds 1 of "), std::string::npos) << first.err;
  waiting.push_back("--resume");
  const Outcome resumed = interrupt(waiting, SIGINT, 50ms);
  EXPECT_EQ(resumed.status, 130) << resumed.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "d.npy.partial"));
}

TEST_F(Interruption, ResumingWithOtherOptionsIsRefusedNamingThem) {
  interrupt_in_time(job("d.npy"), SIGKILL);
  std::vector<std::string> other = job("d.npy");
  other.insert(other.end(), {"--resume", "--seed", "7"});
  const Outcome outcome = run_geodrome(folder_, other);
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("seed"), std::string::npos) << outcome.err;
}

}  // namespace
