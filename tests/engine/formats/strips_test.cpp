// SPDX-License-Identifier: MIT
#include <cstring>

#include "tests/support/input_files.hpp"

// Triangle strips of PLY, as the models of the Stanford archive have them.
namespace geodrome::testing {
namespace {

const std::string six_points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";

std::string header(const std::string& format, int strips) {
  return "ply\nformat " + format + " 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n" +
         "element tristrips " + std::to_string(strips) + "\nproperty list int int vertex_indices\nend_header\n";
}

Input read_strips(const std::string& strips, int count = 1) {
  return read_bytes("s.ply", header("ascii", count) + six_points + strips);
}

TEST(PlyStrips, TurnEverySecondTriangleRound) {
  EXPECT_EQ(read_strips("6 0 1 2 3 4 5\n").triangles,
            (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}}));
}

TEST(PlyStrips, BeginAnewAfterMinusOne) {
  const std::vector<Triangle> two_runs = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}};
  EXPECT_EQ(read_strips("10 0 1 2 3 -1 2 3 4\n 5 -1\n").triangles, two_runs);
  EXPECT_EQ(read_strips("4 0 1 2 3\n4 2 3 4 5\n", 2).triangles, two_runs);
  const Input oriented = read_strips("9 0 1 2 3 -1 2 3 4 5\n");
  EXPECT_TRUE(oriented.facts.oriented);
  EXPECT_FALSE(has_warning(oriented));
}

TEST(PlyStrips, StandBesideFaces) {
  const std::string bytes =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nelement tristrips 1\nproperty list int int "
      "vertex_indices\nend_header\n" +
      six_points + "3 0 1 2\n4 2 1 3 4\n";
  EXPECT_EQ(read_bytes("s.ply", bytes).triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {3, 1, 4}}));
}

TEST(PlyStrips, AreReadFromBinaryFiles) {
  std::string bytes = header("binary_little_endian", 1);
  const auto append = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  for (int v = 0; v < 6; ++v)
    for (const float coordinate : {float(v % 2), float(v / 2), 0.f}) append(coordinate);
  for (const int number : {8, 0, 1, 2, 3, -1, 2, 3, 4}) append(number);
  EXPECT_EQ(read_bytes("s.ply", bytes).triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
  expect_refused([&] { read_bytes("s.ply", bytes.substr(0, bytes.size() - 1)); }, InputFault::truncated, "tristrips");
}

TEST(PlyStrips, ThatAreBrokenAreRefused) {
  expect_refused([] { read_strips("4 0 1 2 6\n"); }, InputFault::index, "strip 0 names vertex 6");
  expect_refused([] { read_strips("4 0 1 2 -2\n"); }, InputFault::index, "vertex -2");
  expect_refused([] { read_strips("6 0 1 2 -1 3 4\n"); }, InputFault::syntax, "run of 2");
  expect_refused([] { read_strips("8 0 1 2 3 4\n"); }, InputFault::truncated, "line 16");
  expect_refused([] { read_strips("-1\n"); }, InputFault::syntax, "negative length");
}

TEST(PlyStrips, HaveNoWeights) {
  const auto weighted = [] {
    read_bytes("s.ply", header("ascii", 1) + six_points + "4 0 1 2 3\n", {.weights = "property:weight"});
  };
  expect_refused(weighted, InputFault::unsupported, "strips have no weights");
}

}  // namespace
}  // namespace geodrome::testing
