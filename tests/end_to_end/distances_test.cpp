// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

/// The matrix of a file's content, through the program.
class Distances : public ::testing::Test {
 protected:
  Outcome run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"distances", input()});
    return run_geodrome(folder_, arguments);
  }
  Matrix matrix(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", (folder_ / "d.npy").string(), "--report", (folder_ / "r.json").string()});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_npy(folder_ / "d.npy");
  }
  json report() const { return json::parse(read_bytes(folder_ / "r.json")); }
  std::string input() const { return (folder_ / name_).string(); }
  void write(const std::string& name, const std::string& content) {
    name_ = name;
    write_bytes(folder_ / name, content);
  }

  TemporaryFolder folder_;
  std::string name_;
};

constexpr const char* two_squares =
    "OFF\n9 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 0 0\n6 0 0\n6 1 0\n5 1 0\n9 9 9\n"
    "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n";

TEST_F(Distances, UnreachableAndIsolatedAreInfiniteAndNeverZero) {
  write("two.off", two_squares);
  const Matrix d = matrix({});
  ASSERT_EQ(d.rows, 9u);
  ASSERT_EQ(d.columns, 9u);
  EXPECT_DOUBLE_EQ(d(1, 3), std::sqrt(2.0));
  EXPECT_TRUE(std::isinf(d(0, 4)));
  EXPECT_TRUE(std::isinf(d(8, 0)));
  EXPECT_TRUE(std::isinf(d(0, 8)));
  EXPECT_EQ(d(8, 8), 0);
  EXPECT_EQ(report()["matrix"]["reach"]["unreachable"], 2 * 16 + 2 * 8);
  EXPECT_EQ(report()["matrix"]["reach"]["missed"], 0);
}

TEST_F(Distances, ArePreparedTogetherByASolverThatCan) {
  write("two.off", two_squares);
  const std::vector<std::string> plugins{"--plugin-path", GEODROME_BINARY_DIR "/tests/sound_plugins"};
  const auto by = [&](const std::string& solver, std::vector<std::string> more = {}) {
    more.insert(more.end(), plugins.begin(), plugins.end());
    more.insert(more.end(), {"--solver", solver});
    return matrix(more);
  };
  const Matrix plain = by("chen_han"), together = by("test_together");
  for (std::size_t k = 0; k < plain.values.size(); ++k) EXPECT_DOUBLE_EQ(together.values[k], plain.values[k]);
  const json plan = report()["matrix"]["many_searches"];
  EXPECT_EQ(plan["used"], true);
  EXPECT_EQ(plan["sources"], 8) << "of the nine rows one lies on no face";
  by("test_together:answer=null");
  EXPECT_EQ(report()["matrix"]["many_searches"]["used"], false);
  by("test_together", {"--sources", "3"});
  EXPECT_FALSE(report()["matrix"].contains("many_searches"));
  const Outcome outcome =
      run({"-o", (folder_ / "d.npy").string(), "--solver", "test_together:answer=throws", plugins[0], plugins[1]});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("solver_test_together: the plan is too large; make it smaller"), std::string::npos)
      << outcome.err;
}

TEST_F(Distances, PreparedTogetherWronglyAreFoundByThePlainSearchesOfTheAudit) {
  write("two.off", two_squares);
  const Outcome outcome = run({"-o", (folder_ / "d.npy").string(), "--sources", "0,1", "--targets", "3", "--solver",
                               "faulty_planned_long", "--plugin-path", GEODROME_BINARY_DIR "/tests/faulty_solvers"});
  EXPECT_EQ(outcome.status, 5) << outcome.out;
  EXPECT_NE(outcome.err.find("broken promise: the audit failed"), std::string::npos) << outcome.err;
}

TEST_F(Distances, BeyondTheLimitIsInfiniteAndCountedApartFromUnreachable) {
  write("two.off", two_squares);
  const Matrix d = matrix({"--max-distance", "1.1"});
  EXPECT_DOUBLE_EQ(d(0, 1), 1);
  EXPECT_TRUE(std::isinf(d(1, 3)));
  EXPECT_EQ(report()["matrix"]["reach"]["beyond_limit"], 8);
  EXPECT_EQ(report()["matrix"]["reach"]["unreachable"], 2 * 16 + 2 * 8);
}

TEST_F(Distances, SourcesAndTargetsAreTakenFromListsAndFiles) {
  write("two.off", two_squares);
  write_bytes(folder_ / "sources.txt", "# a row, a point, a point on a face\n3\n0.5 0.25 7\n0 0.5 0 0.5 + 2.5\n");
  const Matrix d = matrix({"--sources", "@" + (folder_ / "sources.txt").string(), "--targets", "1,2"});
  ASSERT_EQ(d.rows, 3u);
  ASSERT_EQ(d.columns, 2u);
  EXPECT_DOUBLE_EQ(d(0, 0), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(d(1, 0), std::hypot(0.5, 0.25));
  EXPECT_DOUBLE_EQ(d(2, 1), 2.5 + std::sqrt(0.5));
}

TEST_F(Distances, AnyNumberOfThreadsGivesTheSameBytes) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "torus", "--points", "400", "-o", (folder_ / "t.xyz").string()}).status, 0);
  name_ = "t.xyz";
  matrix({"--threads", "1"});
  const std::string one = read_bytes(folder_ / "d.npy");
  matrix({"--threads", "3"});
  EXPECT_TRUE(one == read_bytes(folder_ / "d.npy"));
}

TEST_F(Distances, MergedPointsShareTheirTwinsRowAndDroppedPointsAreNaN) {
  std::string grid;
  for (int i = 0; i < 36; ++i) grid += std::to_string(i / 6) + " " + std::to_string(i % 6) + " 0\n";
  write("p.xyz", grid + "nan 0 0\n" + "2 3 0\n");
  const Matrix d = matrix({"--drop-nonfinite"});
  ASSERT_EQ(d.rows, 38u);
  const std::size_t twin = 2 * 6 + 3;
  for (std::size_t j = 0; j < 36; ++j) {
    EXPECT_EQ(d(37, j), d(twin, j));
    EXPECT_TRUE(std::isnan(d(36, j)));
    EXPECT_TRUE(std::isnan(d(j, 36)));
  }
  EXPECT_EQ(d(37, twin), 0);
  EXPECT_EQ(report()["input"]["merged"], 1);
  EXPECT_EQ(report()["input"]["dropped"], 1);
}

TEST_F(Distances, NearestNamesSourceAndReachAndTheLowestSourceInATie) {
  write("two.off", two_squares);
  const Outcome outcome = run({"--solver", "edge_dijkstra", "--sources", "0,2,8", "--nearest",
                               (folder_ / "n.csv").string(), "--max-distance", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(
      read_bytes(folder_ / "n.csv"),
      "target,distance,source,reach\n0,0,0,reached\n1,1,0,reached\n2,0,2,reached\n3,1,0,reached\n4,inf,,unreachable\n"
      "5,inf,,unreachable\n6,inf,,unreachable\n7,inf,,unreachable\n8,0,8,reached\n");
}

TEST_F(Distances, CsvHoldsTheSameNumbersAsNpy) {
  write("two.off", two_squares);
  const Matrix d = matrix({"--targets", "0,1,2"});
  ASSERT_EQ(run({"--targets", "0,1,2", "-o", (folder_ / "d.csv").string()}).status, 0);
  std::istringstream csv(read_bytes(folder_ / "d.csv"));
  std::string line, word;
  for (std::size_t i = 0; i < d.rows; ++i) {
    ASSERT_TRUE(std::getline(csv, line));
    std::istringstream words(line);
    for (std::size_t j = 0; j < d.columns; ++j) {
      ASSERT_TRUE(std::getline(words, word, ','));
      EXPECT_EQ(std::strtod(word.c_str(), nullptr), d(i, j));
    }
  }
}

TEST_F(Distances, ReportTellsPluginsOptionsInvariantsAuditAndGuarantee) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "torus", "--points", "500", "-o", (folder_ / "t.xyz").string()}).status, 0);
  name_ = "t.xyz";
  matrix({"--sources", "0,1,2,3", "--tangent", "pca:k=24", "--audit", "0.2"});
  const json r = report();
  EXPECT_EQ(r["stages"][0]["plugin"], "tangent_pca");
  EXPECT_EQ(r["stages"][0]["options"]["k"], "24");
  EXPECT_EQ(r["stages"].size(), 5u);
  EXPECT_EQ(r["surface"]["genus"], 1);
  EXPECT_TRUE(r["matrix"]["invariants"]["not_below_euclid"]["holds"]);
  EXPECT_GT(r["matrix"]["invariants"]["triangle_inequality"]["tested"], 0);
  EXPECT_TRUE(r["audit"]["audited"]);
  EXPECT_LT(r["audit"]["worst_lipschitz"], 1e-11);
  EXPECT_LT(r["audit"]["worst_path"], 1e-11);
  EXPECT_FALSE(r["guarantee_of_the_paper"]["claims"].empty());
  EXPECT_EQ(r["input"]["hash"].get<std::string>().size(), 32u);
}

}  // namespace
