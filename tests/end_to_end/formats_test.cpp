// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;

/// Files as other programs write them, whose distances follow by hand.
class InputFiles : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  Outcome run(const std::string& command, const std::string& name, const std::string& bytes,
              std::vector<std::string> options) {
    write_bytes(folder_ / name, bytes);
    options.insert(options.begin(), {command, file(name)});
    return run_geodrome(folder_, options);
  }

  /// The distances from a row to all rows.
  std::vector<double> distances(const std::string& name, const std::string& bytes, int source) {
    const Outcome outcome =
        run("distances", name, bytes, {"--sources", std::to_string(source), "-o", file("d.csv"), "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::istringstream row(read_bytes(folder_ / "d.csv"));
    std::vector<double> values;
    for (std::string number; std::getline(row, number, ',');) values.push_back(std::stod(number));
    return values;
  }

  void expect_octahedron(const std::string& name, const std::string& bytes) {
    SCOPED_TRACE(name);
    const std::vector<double> d = distances(name, bytes, 4);
    ASSERT_EQ(d.size(), 6u);
    EXPECT_NEAR(d[5], std::sqrt(6.), 1e-12);
    EXPECT_NEAR(d[0], std::sqrt(2.), 1e-12);
  }

  void expect_points(const std::string& name, const std::string& bytes, std::vector<std::string> options = {}) {
    SCOPED_TRACE(name);
    options.push_back("--input-only");
    const Outcome outcome = run("check", name, bytes, options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(", 3 points, diagonal 5.099"), std::string::npos) << outcome.out;
  }

  TemporaryFolder folder_;
};

const std::string octahedron_faces = "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";

std::string ply_header(const std::string& properties) {
  return "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n" +
         properties + "element face 8\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST_F(InputFiles, ThatAreStreamsOfNumbers) {
  expect_octahedron("two.off", "OFF\n6\n8 12\n1 0 0 -1 0 0\n0 1 0 0 -1 0\n0 0 1 0 0 -1\n" + octahedron_faces);
  expect_octahedron("colours.ply", ply_header("property uchar red\nproperty uchar green\n") +
                                       "1 0 0\n255 0\n-1 0 0\n255 0\n0 1 0\n255 0\n0 -1 0\n255 0\n0 0 1\n255 0\n" +
                                       "0 0 -1\n255 0\n" + octahedron_faces);
  expect_octahedron("normals.ply", ply_header("property float nx\n") + "1 0 0 -1.#IND\n-1 0 0 1.#QNAN\n" +
                                       "0 1 0 1e400\n0 -1 0 1\n0 0 1 nan\n0 0 -1 0\n" + octahedron_faces);
}

TEST_F(InputFiles, WhoseCommentsEndInABackslash) {
  const std::vector<double> d = distances("plate.obj",
                                          "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
                                          "f 1 2 6\nf 1 6 5\n# C:\\plates\\\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\n",
                                          0);
  EXPECT_NEAR(d[3], 3, 1e-12);
  EXPECT_NEAR(d[7], std::sqrt(10.), 1e-12);
}

TEST_F(InputFiles, WithConcavePolygonsAndHoles) {
  const std::vector<double> round_u = distances(
      "u.obj", "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8\n", 3);
  EXPECT_NEAR(round_u[6], 5, 1e-12);
  // From corner to corner of a square, round the square that is left out of it.
  const std::vector<double> round_hole = distances(
      "hole.off", "OFF\n8 1 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n1 2 0\n2 2 0\n2 1 0\n10 0 1 2 3 0 4 5 6 7 4\n", 0);
  EXPECT_NEAR(round_hole[2], 2 * std::sqrt(5.), 1e-12);
}

TEST_F(InputFiles, OfPointsInColumns) {
  expect_points("scan.pts", "3\n0 0 0 9 255\n1 2 0 9 255\n0 3 4 9 255\n");
  expect_points("names.txt", "//Z X Y Intensity\n0 0 0 9\n0 1 2 9\n4 0 3 9\n");
  expect_points("table.csv", "\"x\";\"y\";\"z\"\n0;0;0\n1;2;0\n0;3;4\n");
  expect_points("index.xyz", "1 0 0 0\n2 1 2 0\n3 0 3 4\n", {"--columns", "2,3,4"});
  expect_points("named.csv", "h,E,N\n0,0,0\n0,1,2\n4,0,3\n", {"--columns", "E,N,h"});
}

TEST_F(InputFiles, OfPointsWithoutTheColumnsThatAreChosen) {
  const std::string three = "0 0 0\n1 2 0\n0 3 4\n";
  EXPECT_EQ(run("check", "p.xyz", three, {"--columns", "2,3,4"}).status, 2);
  EXPECT_EQ(run("check", "p.xyz", three, {"--columns", "x,y,z"}).status, 2);
  const Outcome index = run("distances", "i.xyz", "1 0 0 0\n2 1 2 0\n3 0 3 4\n", {"-o", file("d.csv")});
  EXPECT_EQ(index.status, 3);
  EXPECT_NE(index.err.find("; choose the columns of x, y and z, as --columns 2,3,4 (or 1,2,3 if it is x)\n"),
            std::string::npos)
      << index.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.csv"));
}

}  // namespace
