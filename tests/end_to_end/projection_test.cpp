// SPDX-License-Identifier: MIT
// --query insert and --query printed, through the program.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using namespace std::chrono_literals;
using nlohmann::json;

/// A torus as 500 random points, and its distances by some rule.
class ProjectionRule : public ::testing::Test {
 protected:
  void SetUp() override { make_torus("500"); }

  void make_torus(const std::string& points) {
    const Outcome made = run_geodrome(folder_, {"shape", "torus", "--points", points, "-o", file("t.xyz")});
    ASSERT_EQ(made.status, 0) << made.err;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome run(const std::string& rule, std::vector<std::string> arguments, const std::string& input = "t.xyz") {
    arguments.insert(arguments.begin(), {"distances", file(input), "--query", rule});
    return run_geodrome(folder_, arguments);
  }
  Matrix matrix(const std::string& rule, std::vector<std::string> arguments = {}, const std::string& input = "t.xyz") {
    arguments.insert(arguments.end(), {"-o", file(rule + ".npy"), "--report", file(rule + ".json")});
    const Outcome outcome = run(rule, arguments, input);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_npy(folder_ / (rule + ".npy"));
  }
  json report(const std::string& rule) const { return json::parse(read_bytes(folder_ / (rule + ".json"))); }
  std::vector<std::array<double, 3>> points() const {
    std::vector<std::array<double, 3>> points;
    std::istringstream text(read_bytes(folder_ / "t.xyz"));
    for (std::array<double, 3> p; text >> p[0] >> p[1] >> p[2];) points.push_back(p);
    return points;
  }

  TemporaryFolder folder_;
};

bool same_row(const Matrix& a, const Matrix& b, std::size_t i) {
  for (std::size_t j = 0; j < a.columns; ++j)
    if (a(i, j) != b(i, j)) return false;
  return true;
}

TEST_F(ProjectionRule, ASourceThatWasKeptHasTheSameRowUnderInsertAndNoOtherHas) {
  const Matrix project = matrix("project"), insert = matrix("insert");
  const json counts = report("insert")["matrix"]["insertions"];
  std::size_t same = 0;
  for (std::size_t i = 0; i < project.rows; ++i) same += same_row(project, insert, i);
  EXPECT_EQ(counts["existing"], same);
  EXPECT_GT(counts["existing"], 0);
  EXPECT_GT(counts["cavity"], 0);
  EXPECT_EQ(counts["existing"].get<int>() + counts["cavity"].get<int>() + counts["partial"].get<int>() +
                counts["extended"].get<int>(),
            500);
  EXPECT_FALSE(report("project")["matrix"].contains("insertions"));
}

TEST_F(ProjectionRule, InsertKeepsWhatItPromisesAndSaysWhatItDoesNot) {
  const Matrix d = matrix("insert");
  const auto p = points();
  for (std::size_t i = 0; i < d.rows; ++i) {
    EXPECT_EQ(d(i, i), 0);
    for (std::size_t j = 0; j < d.columns; ++j) {
      ASSERT_GE(d(i, j), std::hypot(p[i][0] - p[j][0], p[i][1] - p[j][1], p[i][2] - p[j][2]) * (1 - 1e-12));
      if (i != j) ASSERT_GT(d(i, j), 0);
    }
  }
  const json run = report("insert")["geodrome"], invariants = report("insert")["matrix"]["invariants"];
  EXPECT_EQ(run["query"], "insert");
  EXPECT_TRUE(run.contains("query_caveat"));
  EXPECT_EQ(invariants["symmetry"]["promised"], false);
  EXPECT_EQ(invariants["triangle_inequality"]["promised"], false);
  EXPECT_EQ(invariants["not_below_euclid"]["promised"], true);
  EXPECT_GT(invariants["symmetry"]["violated"], 0) << "measured all the same";
  EXPECT_EQ(report("insert")["broken_promises"], json::array());
  EXPECT_EQ(report("insert")["audit"]["audited"], true);
}

using Point = std::array<double, 3>;

double length(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// The closest point of the torus of radii 1 and 0.4.
Point on_torus(const Point& p) {
  const double ring = std::hypot(p[0], p[1]), x = p[0] / ring, y = p[1] / ring;
  const double tube = std::hypot(ring - 1, p[2]), r = 1 + 0.4 * (ring - 1) / tube;
  return {r * x, r * y, 0.4 * p[2] / tube};
}

/// The geodesic distance of near points of the torus: the chord, pulled tight on the surface in 16 pieces, which are
/// shorter than the geodesic by 1e-4 of it at most.
double true_distance(const Point& from, const Point& to) {
  constexpr int pieces = 16;
  std::vector<Point> path(pieces + 1);
  const auto between = [](const Point& a, const Point& b, double t) {
    return Point{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  };
  for (int k = 0; k <= pieces; ++k) path[k] = on_torus(between(from, to, static_cast<double>(k) / pieces));
  for (int round = 0; round < 600; ++round)
    for (int k = 1; k < pieces; ++k) path[k] = on_torus(between(path[k - 1], path[k + 1], 0.5));
  double sum = 0;
  for (int k = 0; k < pieces; ++k) sum += length(path[k], path[k + 1]);
  return sum;
}

TEST_F(ProjectionRule, InsertIsCloserToTheTruthForNearPairsThanProject) {
  make_torus("1200");
  const std::vector<Point> p = points();
  std::string rows;
  for (std::size_t i = 0; i < p.size(); i += 60) rows += (i ? "," : "") + std::to_string(i);
  const std::vector<std::string> some{"--sources", rows, "--audit", "0"};
  const Matrix project = matrix("project", some), insert = matrix("insert", some);
  double project_error = 0, insert_error = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < project.rows; ++i)
    for (std::size_t j = 0; j < project.columns; ++j) {
      if (60 * i == j || length(p[60 * i], p[j]) > 0.25) continue;
      const double d = true_distance(p[60 * i], p[j]);
      project_error += std::abs(project(i, j) - d) / d, insert_error += std::abs(insert(i, j) - d) / d;
      ++pairs;
    }
  ASSERT_GT(pairs, 200u);
  EXPECT_LT(insert_error, 0.8 * project_error) << "mean " << project_error / pairs << " and " << insert_error / pairs;
  RecordProperty("project", std::to_string(project_error / pairs));
  RecordProperty("insert", std::to_string(insert_error / pairs));
}

TEST_F(ProjectionRule, PrintedGivesZeroWhereTheNearestVertexIsTheSource) {
  std::string rows = "0";
  for (int i = 5; i < 500; i += 5) rows += "," + std::to_string(i);
  const Matrix printed = matrix("printed", {"--sources", rows}), insert = matrix("insert", {"--sources", rows});
  std::size_t zeros = 0, below = 0;
  for (std::size_t i = 0; i < printed.rows; ++i)
    for (std::size_t j = 0; j < printed.columns; ++j) {
      zeros += 5 * i != j && printed(i, j) == 0;
      below += printed(i, j) < insert(i, j) * (1 - 1e-9);
    }
  for (std::size_t i = 0; i < printed.rows; ++i) EXPECT_EQ(printed(i, 5 * i), 0);
  EXPECT_GT(zeros, 20u);
  EXPECT_GT(below, printed.values.size() / 3) << "biased low";
  const json invariants = report("printed")["matrix"]["invariants"];
  EXPECT_EQ(invariants["not_below_euclid"]["promised"], false);
  EXPECT_GT(invariants["not_below_euclid"]["violated"], 0);
  EXPECT_NE(report("printed")["geodrome"]["query_caveat"].get<std::string>().find("comparison only"),
            std::string::npos);
}

TEST_F(ProjectionRule, WithoutDecimationAllRulesAgreeToTheByte) {
  const std::vector<std::string> all{"--decimator", "none", "--sources", "0,7,150"};
  matrix("project", all), matrix("insert", all), matrix("printed", all);
  EXPECT_TRUE(read_bytes(folder_ / "project.npy") == read_bytes(folder_ / "insert.npy"));
  const Matrix project = read_npy(folder_ / "project.npy"), printed = read_npy(folder_ / "printed.npy");
  for (std::size_t k = 0; k < project.values.size(); ++k)
    EXPECT_NEAR(project.values[k], printed.values[k], 1e-12) << "but for max with |st|, by rounding";
}

TEST_F(ProjectionRule, AnyNumberOfThreadsGivesTheSameBytes) {
  for (const std::string rule : {"insert", "printed"}) {
    matrix(rule, {"--threads", "1", "--solver", "edge_dijkstra"});
    const std::string one = read_bytes(folder_ / (rule + ".npy"));
    matrix(rule, {"--threads", "3", "--solver", "edge_dijkstra"});
    EXPECT_TRUE(one == read_bytes(folder_ / (rule + ".npy"))) << rule;
  }
}

TEST_F(ProjectionRule, AKilledJobResumesToTheSameBytesAndNotUnderAnotherRule) {
  make_torus("700");
  ASSERT_EQ(run("insert", {"-o", file("whole.npy"), "--audit", "0", "--solver", "edge_dijkstra"}).status, 0);
  RunningProgram killed(folder_, "geodrome",
                        {"distances", file("t.xyz"), "--query", "insert", "-o", file("d.npy"), "--threads", "1",
                         "--audit", "0", "--solver", "edge_dijkstra"});
  for (int i = 0; i < 2000 && !std::filesystem::exists(folder_ / "d.npy.partial"); ++i)
    std::this_thread::sleep_for(2ms);
  std::this_thread::sleep_for(30ms);
  killed.send(SIGKILL);
  killed.wait();
  ASSERT_TRUE(std::filesystem::exists(folder_ / "d.npy.partial")) << "the job was too short to be killed";
  const std::vector<std::string> resume{"-o", file("d.npy"), "--audit", "0", "--solver", "edge_dijkstra", "--resume"};
  const Outcome other = run("project", resume);
  EXPECT_EQ(other.status, 4) << other.err;
  EXPECT_NE(other.err.find("query"), std::string::npos) << other.err;
  const Outcome same = run("insert", resume);
  ASSERT_EQ(same.status, 0) << same.err;
  EXPECT_TRUE(read_bytes(folder_ / "d.npy") == read_bytes(folder_ / "whole.npy"));
}

TEST_F(ProjectionRule, APathStartsAtTheInsertedPointAndHasTheDistanceOfTheMatrix) {
  const std::vector<std::string> some{"--sources", "0,1,2,3,4,5,6,7,8,9"};
  const Matrix project = matrix("project", some), insert = matrix("insert", some);
  std::size_t from = 0;
  while (from < insert.rows && same_row(project, insert, from)) ++from;
  ASSERT_LT(from, insert.rows) << "the test needs a row that was not kept";
  const Outcome outcome = run_geodrome(folder_, {"path", file("t.xyz"), "--from", std::to_string(from), "--to", "250",
                                                 "--query", "insert", "-o", file("p.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json path = json::parse(read_bytes(folder_ / "p.json"));
  EXPECT_DOUBLE_EQ(path["distance"], insert(from, 250));
  EXPECT_EQ(path["points"][0]["position"], json(points()[from]));
}

TEST_F(ProjectionRule, ComponentsStayApartAndNothingIsMissed) {
  make_torus("800");
  std::string two = read_bytes(folder_ / "t.xyz");
  for (const auto& p : points())
    two += std::to_string(p[0] + 9) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  write_bytes(folder_ / "two.xyz", two);
  for (const std::string rule : {"insert", "printed"}) {
    const Matrix d = matrix(rule, {"--sources", "0,1,2,800,801,802"}, "two.xyz");
    ASSERT_EQ(report(rule)["surface"]["components"], 2);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 1600; ++j) ASSERT_EQ(std::isinf(d(i, j)), (i < 3) != (j < 800)) << i << " " << j;
    EXPECT_EQ(report(rule)["matrix"]["reach"]["unreachable"], 6 * 800);
  }
}

TEST_F(ProjectionRule, OnAPlanarSampleTheDistancesAreStraightAndTheBoundaryGrows) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "plane", "--points", "400", "-o", file("t.xyz")}).status, 0);
  // A control of one size knows no rims, which are thinned then.
  const Matrix d = matrix("insert", {"--control", "constant", "--solver", "cgal", "--sources", "all"});
  const json counts = report("insert")["matrix"]["insertions"];
  EXPECT_GT(counts["extended"], 0) << "points beyond the boundary of the kept ones";
  EXPECT_EQ(counts["partial"], 0);
  const auto p = points();
  double low = 1e300, high = -1e300;
  for (const auto& q : p) low = std::min({low, q[0], q[1]}), high = std::max({high, q[0], q[1]});
  const auto is_inner = [&](const auto& q) {
    const double margin = 0.2 * (high - low);
    return std::min(q[0], q[1]) > low + margin && std::max(q[0], q[1]) < high - margin;
  };
  std::size_t inner = 0;
  for (std::size_t i = 0; i < d.rows; ++i)
    for (std::size_t j = 0; j < d.columns; ++j)
      if (is_inner(p[i]) && is_inner(p[j])) {
        ++inner;
        ASSERT_NEAR(d(i, j), length(p[i], p[j]), 1e-9 * (high - low)) << i << " " << j;
      }
  EXPECT_GT(inner, 1000u);
}

TEST_F(ProjectionRule, DroppedAndMergedPointsAreTreatedAsEverywhere) {
  write_bytes(
      folder_ / "p.xyz", read_bytes(folder_ / "t.xyz") + "nan 0 0\n" + [&] {
        std::istringstream text(read_bytes(folder_ / "t.xyz"));
        std::string line;
        std::getline(text, line);
        return line + "\n";
      }());
  for (const std::string rule : {"insert", "printed"}) {
    const Matrix d = matrix(rule, {"--drop-nonfinite", "--sources", "0,1,500,501"}, "p.xyz");
    for (std::size_t j = 0; j < 500; ++j) {
      EXPECT_TRUE(std::isnan(d(2, j)));
      EXPECT_EQ(d(0, j), d(3, j));
    }
    EXPECT_TRUE(std::isnan(d(1, 500)));
    EXPECT_EQ(d(0, 501), 0) << "the same point";
  }
}

TEST_F(ProjectionRule, RefusalsSayWhyAndWhatToDo) {
  const auto expect = [&](const Outcome& outcome, int status, const std::string& part) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  };
  expect(run("insert", {"--nearest", file("n.csv")}), 2, "leave --query out");
  write_bytes(folder_ / "s.txt", "0\n1 0 0\n");
  expect(run("printed", {"--sources", "@" + file("s.txt"), "-o", file("d.npy")}), 2, "rows");
  write_bytes(folder_ / "square.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  expect(run("insert", {"-o", file("d.npy")}, "square.off"), 2, "--as points");
  expect(run_geodrome(folder_,
                      {"path", file("t.xyz"), "--from", "0", "--to", "1", "--query", "printed", "-o", file("p.obj")}),
         2, "--query");
}

}  // namespace
