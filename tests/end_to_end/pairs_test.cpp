// SPDX-License-Identifier: MIT
// Distances of pairs and the index file, through the program.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;
namespace fs = std::filesystem;

const std::string plugins = std::string(GEODROME_BINARY_DIR) + "/tests/sound_plugins";

/// An icosphere and pairs on it, answered by the tests' own oracle.
class Queries : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_geodrome(folder_, {"shape", "icosphere", "--mesh", "--faces", "300", "-o", file("m.ply")}).status, 0);
    write_bytes(folder_ / "p.txt", "# from, to\n3, 17\n12 0.2 0.3 0.5, 40 0.1 0.1 0.8\n9, 9\n0.1 0.2 0.3, 5\n");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome queries(const std::vector<std::string>& more, const std::string& solver = "test_pairs",
                  const std::string& input = "m.ply") {
    std::vector<std::string> arguments{"queries",  file(input), "--pairs",       file("p.txt"),
                                       "--solver", solver,      "--plugin-path", plugins};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_geodrome(folder_, arguments);
  }
  std::vector<double> values(const std::string& name) const { return read_npy(folder_ / name).values; }
  json report(const std::string& name) const { return json::parse(read_bytes(folder_ / name)); }
  void expect(const Outcome& outcome, int status, const std::string& word) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Queries, GiveTheDistancesThatSearchesGive) {
  ASSERT_EQ(queries({"-o", file("q.npy")}).status, 0);
  write_bytes(folder_ / "s.txt", "3\n12 0.2 0.3 0.5\n9\n0.1 0.2 0.3\n");
  write_bytes(folder_ / "t.txt", "17\n40 0.1 0.1 0.8\n9\n5\n");
  ASSERT_EQ(run_geodrome(folder_, {"distances", file("m.ply"), "--sources", "@" + file("s.txt"), "--targets",
                                   "@" + file("t.txt"), "-o", file("d.npy")})
                .status,
            0);
  const Matrix matrix = read_npy(folder_ / "d.npy");
  const auto pairs = values("q.npy");
  ASSERT_EQ(pairs.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(pairs[i], matrix(i, i), 1e-12);
  EXPECT_EQ(pairs[2], 0);
}

TEST_F(Queries, AreWrittenAsCsvWithTheEntriesAsTheyWere) {
  ASSERT_EQ(queries({"-o", file("q.csv")}).status, 0);
  std::istringstream text(read_bytes(folder_ / "q.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0], "pair,from,to,distance,reach");
  EXPECT_EQ(lines[1].substr(0, 7), "0,3,17,");
  EXPECT_EQ(lines[2].substr(0, 33), "1,12 0.2 0.3 0.5,40 0.1 0.1 0.8,1");
  EXPECT_EQ(lines[3], "2,9,9,0,reached");
  EXPECT_EQ(lines[4].substr(0, 16), "3,0.1 0.2 0.3,5,");
}

TEST_F(Queries, BuildTheIndexOnceAndReadItToTheSameBytes) {
  const Outcome first = queries({"-o", file("a.npy"), "--index", file("i.index"), "--report", file("a.json")});
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("saved to " + file("i.index")), std::string::npos) << first.out;
  const std::string index = read_bytes(folder_ / "i.index");
  const Outcome second = queries({"-o", file("b.npy"), "--index", file("i.index"), "--report", file("b.json")});
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_NE(second.out.find("read from " + file("i.index")), std::string::npos) << second.out;
  EXPECT_TRUE(read_bytes(folder_ / "a.npy") == read_bytes(folder_ / "b.npy"));
  EXPECT_TRUE(read_bytes(folder_ / "i.index") == index) << "an index that is there is never written";
  EXPECT_EQ(report("a.json")["oracle"]["origin"], "built");
  EXPECT_EQ(report("b.json")["oracle"]["origin"], "read");
  EXPECT_EQ(report("b.json")["oracle"]["index_bytes"], index.size());
}

TEST_F(Queries, GiveTheSameBytesForAnyNumberOfThreads) {
  std::string pairs;
  for (int i = 0; i < 2000; ++i) pairs += std::to_string(i % 160) + ", " + std::to_string(i * 7 % 161) + "\n";
  write_bytes(folder_ / "p.txt", pairs);
  ASSERT_EQ(queries({"-o", file("a.npy"), "--threads", "1"}).status, 0);
  ASSERT_EQ(queries({"-o", file("b.npy"), "--threads", "3"}).status, 0);
  EXPECT_TRUE(read_bytes(folder_ / "a.npy") == read_bytes(folder_ / "b.npy"));
}

TEST_F(Queries, RefuseAnIndexThatBelongsToSomethingElseAndLeaveItAlone) {
  ASSERT_EQ(queries({"-o", file("a.npy"), "--index", file("i.index")}).status, 0);
  const std::string index = read_bytes(folder_ / "i.index");
  const std::vector<std::string> again{"-o", file("b.npy"), "--index", file("i.index")};
  expect(queries(again, "test_pairs:rounds=2"), 3, "rounds was 1 and is 2");
  ASSERT_EQ(run_geodrome(folder_, {"shape", "icosphere", "--mesh", "--faces", "100", "-o", file("n.ply")}).status, 0);
  write_bytes(folder_ / "p.txt", "3, 17\n");
  expect(queries(again, "test_pairs", "n.ply"), 3, "another mesh");
  expect(queries({"-o", file("b.npy"), "--index", file("i.index"), "--seed", "2"}), 3, "seed");
  EXPECT_TRUE(read_bytes(folder_ / "i.index") == index);
  write_bytes(folder_ / "i.index", index.substr(0, index.size() / 2));
  expect(queries(again), 3, "truncated");
  std::string damaged = index;
  damaged[index.size() - 9] ^= 1;
  write_bytes(folder_ / "i.index", damaged);
  expect(queries(again), 3, "damaged");
  EXPECT_FALSE(fs::exists(folder_ / "b.npy"));
}

TEST_F(Queries, SayWhichSolversCan) {
  expect(queries({"-o", file("q.npy")}, "chen_han"), 3, "solver_chen_han does not provide");
  write_bytes(folder_ / "m.ply", "no mesh at all");
  const Outcome outcome = run_geodrome(
      folder_, {"queries", file("m.ply"), "--pairs", file("p.txt"), "-o", file("q.npy"), "--solver", "edge_dijkstra"});
  expect(outcome, 3, "pair_queries");
  expect(outcome, 3, "geodrome distances");
  EXPECT_FALSE(fs::exists(folder_ / "q.npy"));
}

TEST_F(Queries, NameTheLineOfABadPairsFile) {
  write_bytes(folder_ / "p.txt", "0, 1\n0 1 2\n");
  expect(queries({"-o", file("q.npy")}), 3, "p.txt: line 2");
  write_bytes(folder_ / "p.txt", "0, 99999\n");
  expect(queries({"-o", file("q.npy")}), 3, "row 99999 does not exist");
  fs::remove(folder_ / "p.txt");
  expect(queries({"-o", file("q.npy")}), 3, "p.txt");
}

TEST_F(Queries, FindMistakesInNamesBeforeAnythingIsComputed) {
  expect(queries({"-o", file("q.txt")}), 2, ".npy");
  expect(queries({"-o", file("q.npy"), "--index", file("no/i.index")}), 3, "make it first");
  expect(queries({"-o", file("q.csv"), "--index", file("q.csv")}), 2, "two outputs");
  write_bytes(folder_ / "old.csv", "old");
  expect(queries({"-o", file("old.csv"), "--index", file("old.csv")}), 2, "that is read");
  expect(queries({"-o", file("p.txt") + ".csv", "--index", file("p.txt")}), 3, "no index file");
  expect(queries({}), 2, "output");
}

TEST_F(Queries, BetweenComponentsAndOnNoFaceAreInfinite) {
  write_bytes(folder_ / "two.off", "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n9 9 9\n3 0 1 2\n3 3 4 5\n");
  write_bytes(folder_ / "p.txt", "0, 1\n0, 3\n6, 6\n6, 0\n");
  const Outcome outcome = queries({"-o", file("q.csv"), "--report", file("r.json")}, "test_pairs", "two.off");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(read_bytes(folder_ / "q.csv"),
            "pair,from,to,distance,reach\n0,0,1,1,reached\n1,0,3,inf,unreachable\n2,6,6,0,reached\n"
            "3,6,0,inf,unreachable\n");
  EXPECT_EQ(report("r.json")["pairs"]["unreachable"], 2);
  EXPECT_EQ(report("r.json")["pairs"]["asked_of_the_oracle"], 2);
}

TEST_F(Queries, OfAnOracleThatBreaksPromisesAreWrittenWithStatusFive) {
  expect(queries({"-o", file("short.npy")}, "test_pairs:fault=short"), 5, "shorter than the straight line");
  EXPECT_TRUE(fs::exists(folder_ / "short.npy"));
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=everywhere_inf"), 5, "within a component are inf");
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=away_from_itself"), 5,
         "1 distances of points from themselves");
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=away_from_itself"), 5, "the audit failed: pair");
  write_bytes(folder_ / "two.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n");
  write_bytes(folder_ / "p.txt", "0, 3\n");
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=never_inf", "two.off"), 5, "between components are numbers");
}

TEST_F(Queries, OfAnOracleThatFailsNameThePluginAndWriteNothing) {
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=nan"), 5, "pair 0 (3, 17)");
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=negative"), 5, "solver_test_pairs");
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=throws"), 5, "a pair too far");
  expect(queries({"-o", file("q.npy")}, "test_pairs:fault=no_oracle"), 5, "made no oracle");
  expect(queries({"-o", file("q.npy"), "--index", file("i")}, "test_pairs:fault=save_throws"), 5, "the table is gone");
  EXPECT_FALSE(fs::exists(folder_ / "i"));
  EXPECT_FALSE(fs::exists(folder_ / "q.npy"));
}

TEST_F(Queries, OfACloudAreThoseOfTheMatrix) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "torus", "--points", "500", "-o", file("t.xyz")}).status, 0);
  write_bytes(folder_ / "t.xyz", read_bytes(folder_ / "t.xyz") + "nan 0 0\n");
  ASSERT_EQ(run_geodrome(folder_, {"distances", file("t.xyz"), "--drop-nonfinite", "-o", file("d.npy"), "--audit", "0",
                                   "--sources", "0,100,500"})
                .status,
            0);
  std::string pairs;
  for (const char* from : {"0", "100", "500"})
    for (int j = 0; j <= 500; j += 50) pairs += from + (", " + std::to_string(j)) + "\n";
  write_bytes(folder_ / "p.txt", pairs);
  const Outcome outcome =
      queries({"-o", file("q.npy"), "--drop-nonfinite", "--report", file("r.json")}, "test_pairs", "t.xyz");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Matrix matrix = read_npy(folder_ / "d.npy");
  const auto got = values("q.npy");
  for (std::size_t i = 0, k = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= 500; j += 50, ++k) {
      EXPECT_EQ(std::isnan(got[k]), std::isnan(matrix(i, j)));
      if (!std::isnan(got[k])) {
        EXPECT_NEAR(got[k], matrix(i, j), 1e-12) << i << " " << j;
      }
    }
  EXPECT_EQ(report("r.json")["pairs"]["not_computed"], 13);
  EXPECT_TRUE(report("r.json").contains("sample"));
}

TEST_F(Queries, AreReportedWithProvenanceAndFigures) {
  ASSERT_EQ(queries({"-o", file("q.npy"), "--report", file("r.json"), "--threads", "2"}, "test_pairs:stretch=2").status,
            0);
  const json r = report("r.json");
  EXPECT_EQ(r["geodrome"]["threads"], 2);
  EXPECT_EQ(r["input"]["rows"], 162);
  EXPECT_EQ(r["stages"][0]["plugin"], "solver_test_pairs");
  EXPECT_EQ(r["solver_factor"], 2.0);
  EXPECT_EQ(r["pairs"]["count"], 4);
  EXPECT_EQ(r["pairs"]["hash"].get<std::string>().size(), 32u);
  EXPECT_GT(r["pairs"]["microseconds_per_query"].get<double>(), 0);
  EXPECT_FALSE(r["oracle"].contains("index_bytes"));
  EXPECT_TRUE(r["broken_promises"].empty());
  EXPECT_EQ(r["audit"]["pairs"], 3);
  EXPECT_LT(r["audit"]["worst"].get<double>(), 1e-12) << "of what the factor 2 allows";
}

TEST_F(Queries, ThatAreCancelledLeaveNothingHalf) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "icosphere", "--mesh", "--faces", "20000", "-o", file("m.ply")}).status, 0);
  write_bytes(folder_ / "p.txt", "0, 1\n");
  RunningProgram running(folder_, "geodrome",
                         {"queries", file("m.ply"), "--pairs", file("p.txt"), "--solver", "test_pairs", "--plugin-path",
                          plugins, "--index", file("i.index"), "-o", file("q.npy")});
  usleep(700'000);  // vetting and reading take a part of that, building minutes
  running.send(SIGINT);
  EXPECT_EQ(running.wait().status, 130);
  EXPECT_FALSE(fs::exists(folder_ / "i.index"));
  EXPECT_FALSE(fs::exists(folder_ / "q.npy"));
}

}  // namespace
