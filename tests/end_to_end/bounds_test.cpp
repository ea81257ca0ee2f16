// SPDX-License-Identifier: MIT
// Distances by an accuracy, and their lower bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/npy.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

class ByAccuracy : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run({"shape", "bumpy", "--mesh", "--faces", "1300", "-o", file("m.ply")}).status, 0);
  }
  Outcome run(const std::vector<std::string>& arguments) { return run_geodrome(folder_, arguments); }
  Outcome on_mesh(const std::string& command, std::vector<std::string> more) {
    more.insert(more.begin(), {command, file("m.ply")});
    return run(more);
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(ByAccuracy, DistancesAreThoseOfTheSolverThatItNames) {
  const std::vector<std::string> asked{"--sources", "0,5", "-o", file("d.npy")};
  const auto distances = [&](const std::string& option, const std::string& value) {
    std::vector<std::string> arguments = asked;
    arguments.insert(arguments.end(), {option, value});
    const Outcome outcome = on_mesh("distances", arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_bytes(folder_ / "d.npy");
  };
  EXPECT_EQ(distances("--accuracy", "1e-2"), distances("--solver", "merged_windows:delta=0.01"));
  EXPECT_EQ(distances("--accuracy", "exact"), distances("--solver", "chen_han"));
  EXPECT_NE(distances("--accuracy", "1e-2"), distances("--accuracy", "exact"));
}

TEST_F(ByAccuracy, NearestPathsAndComparisonsHeedIt) {
  const Outcome nearest =
      on_mesh("distances", {"--sources", "0", "--nearest", file("n.csv"), "--nearest-bounds", "--accuracy", "0.1"});
  EXPECT_EQ(nearest.status, 0) << nearest.err;
  EXPECT_NE(nearest.out.find("solver_merged_windows, at most 1.1 times"), std::string::npos) << nearest.out;
  EXPECT_NE(nearest.out.find("certified  nearest: off by at most"), std::string::npos) << nearest.out;
  EXPECT_TRUE(read_bytes(folder_ / "n.csv").starts_with("target,distance,source,reach,lower_bound\n0,0,0,reached,0\n"));
  const Outcome path = on_mesh("path", {"--from", "0", "--to", "99", "-o", file("p.obj"), "--accuracy", "0.1"});
  EXPECT_EQ(path.status, 0) << path.err;
  EXPECT_EQ(path.out.rfind("distance ", 0), 0u) << path.out;
  const Outcome compared = on_mesh("compare", {"--accuracy", "1e-2", "--truth", "exact"});
  EXPECT_EQ(compared.status, 0) << compared.err;
  EXPECT_NE(compared.out.find("merged_windows:delta=0.01"), std::string::npos) << compared.out;
}

TEST_F(ByAccuracy, PairsAreAnsweredByAnOracle) {
  write_bytes(folder_ / "pairs.txt", "0, 5\n3, 99\n");
  const std::vector<std::string> asked{"--pairs", file("pairs.txt"), "-o", file("q.csv"), "--accuracy"};
  const auto queries = [&](const std::string& accuracy) {
    std::vector<std::string> arguments = asked;
    arguments.push_back(accuracy);
    return on_mesh("queries", arguments);
  };
  const Outcome answered = queries("0.2");
  EXPECT_EQ(answered.status, 0) << answered.err;
  EXPECT_NE(answered.out.find("solver_aleksandrov, at most 1.2 times"), std::string::npos) << answered.out;
  for (const char* none : {"exact", "1e-5"}) {
    const Outcome refused = queries(none);
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("a number from 1e-04"), std::string::npos) << refused.err;
  }
}

TEST_F(ByAccuracy, ASampleIsMeasuredByIt) {
  ASSERT_EQ(run({"shape", "torus", "--points", "400", "-o", file("t.xyz")}).status, 0);
  const Outcome outcome = run({"distances", file("t.xyz"), "--sources", "0,7", "--accuracy", "0.01", "-o",
                               file("d.npy"), "--bounds", file("l.npy"), "--report", file("r.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Matrix d = read_npy(folder_ / "d.npy"), l = read_npy(folder_ / "l.npy");
  for (std::size_t k = 0; k < d.values.size(); ++k) {
    EXPECT_LE(l.values[k], d.values[k]);
    EXPECT_LE(d.values[k], 1.01 * l.values[k] * (1 + 1e-12));
  }
  const json report = json::parse(read_bytes(folder_ / "r.json"));
  EXPECT_EQ(report["geodrome"]["bounds"], file("l.npy"));
  EXPECT_LE(report["matrix"]["certified"]["largest"], 0.01 * (1 + 1e-12));
  EXPECT_EQ(report["broken_promises"], json::array());
}

TEST_F(ByAccuracy, AndASolverByNameAreOneTooMany) {
  const Outcome both = on_mesh("distances", {"--solver", "chen_han", "--accuracy", "exact", "-o", file("d.npy")});
  EXPECT_EQ(both.status, 2);
  EXPECT_NE(both.err.find("--solver excludes --accuracy"), std::string::npos) << both.err;
  for (const char* none : {"0", "2", "nan", "", "high"}) {
    const Outcome refused = on_mesh("distances", {"--accuracy", none, "-o", file("d.npy")});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("say exact, or name a number from 1e-06 to 1"), std::string::npos) << refused.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy"));
}

TEST_F(ByAccuracy, ComparisonsShowWhatIsCertifiedBesideTheErrors) {
  const Outcome table =
      on_mesh("compare", {"--stage", "solver=chen_han,merged_windows:delta=0.01,merged_windows:delta=0.01,value=middle",
                          "-o", file("f.json")});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("  certified  "), std::string::npos) << table.out;
  const json combinations = json::parse(read_bytes(folder_ / "f.json"))["combinations"];
  EXPECT_FALSE(combinations[0].contains("certified"));
  for (const std::size_t k : {1, 2}) {
    EXPECT_GE(combinations[k]["certified"]["largest"], combinations[k]["errors"]["max_over"]);
    EXPECT_GE(combinations[k]["certified"]["largest"], combinations[k]["errors"]["max_under"]);
  }
  EXPECT_EQ(combinations[1]["never_shorter"], true);
  EXPECT_EQ(combinations[2]["never_shorter"], false);
  EXPECT_TRUE(combinations[2]["factor"].is_null());
  const Outcome plain = on_mesh("compare", {"--stage", "solver=chen_han,edge_dijkstra"});
  EXPECT_EQ(plain.out.find("certified"), std::string::npos) << plain.out;
}

TEST_F(ByAccuracy, BoundsAreRefusedByNameWhereThereAreNone) {
  const Outcome outcome =
      on_mesh("distances", {"-o", file("d.npy"), "--bounds", file("l.npy"), "--solver", "edge_dijkstra"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("solver_edge_dijkstra gives no lower bounds"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--accuracy"), std::string::npos) << outcome.err;
  EXPECT_EQ(on_mesh("distances", {"--nearest", file("n.csv"), "--bounds", file("l.npy")}).status, 2);
  EXPECT_EQ(on_mesh("distances", {"-o", file("d.npy"), "--nearest-bounds"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy"));
}

/// Bounds a millionth above their distances contradict them at nearly every vertex, and no second search is needed.
TEST_F(ByAccuracy, IntervalsThatCannotBeAreABrokenPromise) {
  const std::string faulty = GEODROME_BINARY_DIR "/tests/faulty_solvers/solver_faulty_long_bounds.so";
  const Outcome matrix = on_mesh("distances", {"--sources", "0,5", "-o", file("d.npy"), "--solver", faulty});
  EXPECT_EQ(matrix.status, 5);
  EXPECT_NE(matrix.err.find("the audit failed: the interval that row "), std::string::npos) << matrix.err;
  const Outcome nearest = on_mesh("distances", {"--sources", "0,5", "--nearest", file("n.csv"), "--solver", faulty});
  EXPECT_EQ(nearest.status, 5);
  EXPECT_NE(nearest.err.find("the interval that the search from all sources certifies"), std::string::npos)
      << nearest.err;
  const Outcome compared = on_mesh("compare", {"--solver", faulty});
  EXPECT_EQ(compared.status, 5);
  EXPECT_NE(compared.err.find("the intervals that it certifies miss by"), std::string::npos) << compared.err;
}

}  // namespace
