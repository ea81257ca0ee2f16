// SPDX-License-Identifier: MIT
// A combination that dies loses no other row, and no process outlives the comparison.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using namespace std::chrono_literals;
using nlohmann::json;

constexpr const char* bad_plugins = GEODROME_BINARY_DIR "/tests/bad_plugins";

class CompareApart : public ::testing::Test {
 protected:
  CompareApart() {
    EXPECT_EQ(run_geodrome(folder_, {"shape", "bumpy", "--mesh", "--faces", "300", "-o", mesh()}).status, 0);
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string mesh() const { return file("bumpy.ply"); }
  std::vector<std::string> arguments(const std::string& solvers, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"compare",   mesh(), "--stage",       "solver=" + solvers,
                                 "--sources", "0,1",  "--plugin-path", bad_plugins};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Outcome run(const std::string& solvers, const std::vector<std::string>& more = {}) {
    return run_geodrome(folder_, arguments(solvers, more));
  }
  json figures(const std::string& solvers, int status) {
    const Outcome outcome = run(solvers, {"--json"});
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return json::parse(outcome.out);
  }
  /// The processes that work on this test's files.
  int processes() const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const std::string name = entry.path().filename();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      count += read_bytes(entry.path() / "cmdline").find(mesh()) != std::string::npos;
    }
    return count;
  }
  /// Whether there are so many twice running: a process that is about to become another one counts for a moment.
  bool soon(int wanted) const {
    int seen = 0;
    for (int tries = 0; tries < 1000 && seen < 2; ++tries) {
      seen = processes() == wanted ? seen + 1 : 0;
      std::this_thread::sleep_for(10ms);
    }
    return seen == 2;
  }

  TemporaryFolder folder_;
};

/// The numbers of a row that do not depend on time and memory.
json numbers(const json& row) { return {row["errors"], row["invariants"], row["guarantee"], row["counters"]}; }

TEST_F(CompareApart, WhatDiesIsARowAndTheOthersAreWhatTheyWere) {
  const json right = figures("chen_han,edge_dijkstra", 0)["combinations"];
  for (const auto& [name, words] :
       {std::pair("crashes_in_run", "solver_bad_crashes_in_run (stage solver) crashed with SIGSEGV"),
        std::pair("aborts_in_run", "crashed with SIGABRT"), std::pair("overflows_in_run", "crashed with SIGSEGV"),
        std::pair("terminates_in_run", "thread lost its way"),
        std::pair("exits_in_run", "ended its process with status 0"),
        std::pair("is_killed_in_run", "ended by SIGKILL")}) {
    const json rows = figures("chen_han,bad_" + std::string(name) + ",edge_dijkstra", 5)["combinations"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[1].size(), 3u) << "name, stages, error";
    EXPECT_EQ(rows[1]["error"]["status"], 5);
    EXPECT_NE(rows[1]["error"]["text"].get<std::string>().find(words), std::string::npos) << rows[1];
    EXPECT_EQ(numbers(rows[0]), numbers(right[0])) << name;
    EXPECT_EQ(numbers(rows[2]), numbers(right[1])) << name;
  }
}

TEST_F(CompareApart, TheFirstThatLivesIsTheTruth) {
  const json f = figures("bad_crashes_in_run,chen_han,bad_aborts_in_run", 5);
  EXPECT_EQ(f["truth"]["name"], "chen_han");
  EXPECT_TRUE(f["combinations"][1]["error"].is_null());
  EXPECT_FALSE(f["combinations"][2]["error"].is_null());
}

TEST_F(CompareApart, FiguresAreWrittenThoughOneDied) {
  const Outcome outcome = run("bad_crashes_in_run,chen_han", {"-o", file("f.json")});
  EXPECT_EQ(outcome.status, 5);
  EXPECT_NE(outcome.out.find("bad_crashes_in_run not run: "), std::string::npos) << outcome.out;
  EXPECT_EQ(json::parse(read_bytes(folder_ / "f.json"))["combinations"].size(), 2u);
}

TEST_F(CompareApart, InterruptedTwiceOrKilledItLeavesNoProcess) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    RunningProgram program(folder_, "geodrome", arguments("chen_han,bad_hangs_in_run"));
    ASSERT_TRUE(soon(4)) << "the program, its child, and one for either combination; there are " << processes();
    program.send(signal);
    if (signal != SIGKILL) {
      std::this_thread::sleep_for(200ms);  // what never asks is not ended by the first
      EXPECT_EQ(processes(), 4);
      program.send(signal);
    }
    EXPECT_EQ(program.wait().status, signal == SIGKILL ? 128 + SIGKILL : 130);
    EXPECT_TRUE(soon(0)) << processes();
  }
}

TEST_F(CompareApart, WhatAsksIsCancelledByTheFirstInterrupt) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "bumpy", "--mesh", "--faces", "20000", "-o", mesh()}).status, 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    RunningProgram program(folder_, "geodrome",
                           {"compare", mesh(), "--solver", "chen_han", "--sources", "all", "-o", file("f.json")});
    ASSERT_TRUE(soon(3)) << processes();
    program.send(signal);
    EXPECT_EQ(program.wait().status, 130);
    EXPECT_TRUE(soon(0)) << processes();
    EXPECT_FALSE(std::filesystem::exists(file("f.json")));
  }
}

TEST_F(CompareApart, BadSourcesAreToldThoughNoSolverCanBeLoaded) {
  const auto told = [&](const std::string& sources, const std::string& words) {
    const Outcome outcome = run_geodrome(folder_, {"compare", mesh(), "--solver", "no_such", "--sources", sources});
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    return outcome.status;
  };
  EXPECT_EQ(told("0,99999", "row 99999 does not exist"), 2);
  write_bytes(folder_ / "s.txt", "1\n99999 0.2 0.3 0.5\n");
  EXPECT_EQ(told("@" + file("s.txt"), "line 2: face 99999 does not exist"), 3);
}

}  // namespace
