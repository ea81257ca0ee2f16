// SPDX-License-Identifier: MIT
// Inputs that programs are reported to get wrong or to refuse, with the right value.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/npy.hpp"

namespace {

using namespace geodrome::testing;

const std::filesystem::path reported = std::filesystem::path(GEODROME_SHARED_DATA) / "reported";

class Reported : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(reported)) GTEST_SKIP() << reported << " is not there";
  }

  static std::string path(const std::string& name) { return (reported / name).string(); }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  Outcome run(const std::string& name, const std::string& sources, std::vector<std::string> options) {
    options.insert(options.begin(), {"distances", path(name), "--sources", sources});
    const Outcome outcome = run_geodrome(folder_, options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome;
  }
  Matrix distances(const std::string& name, const std::string& sources, std::vector<std::string> options = {}) {
    options.insert(options.end(), {"-o", file("d.npy")});
    outcome_ = run(name, sources, options);
    return read_npy(folder_ / "d.npy");
  }
  static std::string list(const std::string& name) { return "@" + path(name); }
  bool is_warned_of(const std::string& words) const { return outcome_.err.find(words) != std::string::npos; }

  void expect_octahedron(const std::string& name) {
    const Matrix d = distances(name, "4");
    ASSERT_EQ(d.columns, 6U);
    EXPECT_NEAR(d(0, 5), std::sqrt(6), 1e-9);
    for (std::size_t corner = 0; corner < 4; ++corner) EXPECT_NEAR(d(0, corner), std::sqrt(2), 1e-9);
    EXPECT_NE(outcome_.out.find("6 vertices, 8 faces, closed"), std::string::npos) << outcome_.out;
  }

  TemporaryFolder folder_;
  Outcome outcome_;
};

TEST_F(Reported, ACommentThatEndsInABackslashSwallowsNoFace) {
  const Matrix d = distances("comment_ends_with_backslash.obj", "0");
  EXPECT_NEAR(d(0, 3), 3, 1e-9);
  EXPECT_NEAR(d(0, 4), 4, 1e-9);
  EXPECT_NEAR(d(0, 9), std::sqrt(17), 1e-9);
  EXPECT_NE(outcome_.out.find("10 vertices, 8 faces"), std::string::npos) << outcome_.out;
}

TEST_F(Reported, TwoSourcesInOneFaceAreBothSeenByCgal) {
  const double right[] = {0.2236067977, 0.9219544457, 0.1414213562, 0.9055385138};
  run("square.off", list("two_sources_in_one_face.txt"), {"--nearest", file("n.csv"), "--solver", "cgal"});
  std::istringstream rows(read_bytes(folder_ / "n.csv"));
  std::string row;
  std::getline(rows, row);
  for (std::size_t vertex = 0; vertex < 4; ++vertex) {
    ASSERT_TRUE(std::getline(rows, row));
    EXPECT_NEAR(std::stod(row.substr(row.find(',') + 1)), right[vertex], 1e-9) << row;
  }
}

TEST_F(Reported, ASeamThatIsThereTwiceIsToldWithTheToleranceThatJoinsIt) {
  distances("globe_with_seam.off", "40", {"--weld", "--targets", "50"});
  EXPECT_TRUE(is_warned_of("--weld 1e-15 joins them")) << outcome_.err;
  const Matrix joined = distances("globe_with_seam.off", "40", {"--weld", "1e-15", "--targets", "50"});
  EXPECT_NEAR(joined(0, 0), 1.0329507724, 1e-9);
}

TEST_F(Reported, SourcesFarFromTheSurfaceAreTold) {
  distances("square.off", list("far_source.txt"));
  EXPECT_TRUE(is_warned_of("lies off the surface")) << outcome_.err;
  EXPECT_TRUE(is_warned_of("1224 times its diagonal")) << outcome_.err;
  distances("square.off", list("three_rows_on_one_line.txt"));
  EXPECT_TRUE(is_warned_of("three whole numbers that could be rows")) << outcome_.err;
}

TEST_F(Reported, FinePartsFarOutAreNotLostInFloatsUntold) {
  const Outcome written = run_geodrome(folder_, {"surface", path("fine_in_utm.off"), "-o", file("m.stl")});
  EXPECT_EQ(written.status, 0);
  EXPECT_NE(written.err.find("135 vertices fall together"), std::string::npos) << written.err;
  EXPECT_NE(written.err.find("write .ply"), std::string::npos) << written.err;
}

TEST_F(Reported, ATangleIsSolvedByBothExactSolversAlike) {
  const Matrix chen_han = distances("tangle_flat.off", "0");
  const Matrix schreiber = distances("tangle_flat.off", "0", {"--solver", "schreiber"});
  ASSERT_EQ(chen_han.columns, 12U);
  for (std::size_t v = 0; v < 12; ++v) EXPECT_NEAR(chen_han(0, v), schreiber(0, v), 1e-12 * (1 + schreiber(0, v)));
}

TEST_F(Reported, ARolledSheetIsNotCrossed) {
  const Matrix d = distances("rolled_sheet.xyz", "0", {"--targets", "149"});
  EXPECT_NEAR(d(0, 0), 89.373, 0.01 * 89.373);
}

TEST_F(Reported, AConcavePolygonIsWalkedAround) {
  EXPECT_NEAR(distances("concave_polygon_u.obj", "3", {"--targets", "6"})(0, 0), 5, 1e-9);
}

TEST_F(Reported, TextIsAStreamOfNumbers) {
  expect_octahedron("vertex_on_two_lines.ply");
  expect_octahedron("two_vertices_a_line.off");
  expect_octahedron("normal_minus_ind.ply");
}

TEST_F(Reported, PointsComeWithACountOrNamesOfColumns) {
  EXPECT_EQ(distances("count_line.pts", "0").columns, 200U);
  EXPECT_EQ(distances("column_names.txt", "0").columns, 200U);
}

TEST_F(Reported, PlacesAndRowsAreReadAsProgramsWriteThem) {
  const Matrix place = distances("square.off", list("barycentric_rounding.txt"));
  const double right[] = {1.0770329614, 1.1661903790, 0.4, 0.6};
  for (std::size_t v = 0; v < 4; ++v) EXPECT_NEAR(place(0, v), right[v], 1e-9);
  const Matrix rows = distances("square.off", list("rows_by_savetxt.txt"));
  ASSERT_EQ(rows.rows, 2U);
  EXPECT_EQ(rows(0, 0), 0);
  EXPECT_EQ(rows(1, 3), 0);
}

}  // namespace
