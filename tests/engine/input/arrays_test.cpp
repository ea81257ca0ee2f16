// SPDX-License-Identifier: MIT
// Inputs from memory: the check of files, with names for the entries of arrays.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The unit square as two triangles, and a vertex on no face.
struct Square {
  std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}};
  std::vector<Triangle> faces{{0, 1, 2}, {0, 2, 3}};
  std::vector<double> weights;

  Arrays arrays() const { return {.positions = positions, .faces = faces, .weights = weights}; }
  Input input(const ReadOptions& options = {}) const { return make_input(arrays(), options); }
};

TEST(InputFromArrays, IsWhatTheFileGives) {
  const Input file = read_bytes("square.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 2 3\n");
  const Input made = Square().input();
  expect_valid(made);
  EXPECT_EQ(made.kind, InputKind::mesh);
  EXPECT_EQ(made.positions, file.positions);
  EXPECT_EQ(made.triangles, file.triangles);
  EXPECT_EQ(made.element_of_row, file.element_of_row);
  EXPECT_EQ(made.face_of_triangle, file.face_of_triangle);
  EXPECT_EQ(made.facts.boundary_edges, file.facts.boundary_edges);
  EXPECT_EQ(made.facts.isolated_vertices, 1u);
  ASSERT_EQ(made.findings.size(), file.findings.size());
  for (std::size_t i = 0; i < made.findings.size(); ++i) EXPECT_EQ(made.findings[i].message, file.findings[i].message);
  EXPECT_TRUE(made.file.empty());
  EXPECT_EQ(made.format, "arrays");
}

TEST(InputFromArrays, IsToldApartByItsHash) {
  Square one, other;
  EXPECT_EQ(one.input().hash, other.input().hash);
  other.positions[4].z = 6;
  EXPECT_NE(one.input().hash, other.input().hash);
  other = one;
  std::swap(other.faces[0], other.faces[1]);
  EXPECT_NE(one.input().hash, other.input().hash);
}

TEST(InputFromArrays, WithoutFacesIsPoints) {
  Square square;
  square.faces.clear();
  square.positions.push_back({1, 0, 0});
  const Input input = square.input();
  expect_valid(input);
  EXPECT_EQ(input.kind, InputKind::points);
  EXPECT_EQ(input.positions.size(), 5u);
  EXPECT_EQ(input.element_of_row[5], 1u) << "the same place";
  EXPECT_EQ(Square().input({.as = InputKind::points}).kind, InputKind::points) << "the vertices alone";
}

TEST(InputFromArrays, DropsAndWeldsAsFilesDo) {
  Square square;
  square.positions[4] = square.positions[1];
  EXPECT_EQ(square.input({.weld = true}).positions.size(), 4u);
  square.faces.clear();
  square.positions[3].x = nan;
  const Input dropped = square.input({.drop_nonfinite = true});
  EXPECT_EQ(dropped.element_of_row[3], no_index);
}

TEST(InputFromArrays, TakesWeightsOfFaces) {
  Square square;
  square.weights = {1, 2.5};
  const Input input = square.input();
  EXPECT_EQ(input.weights, square.weights);
  EXPECT_FALSE(input.weights_hash.empty());
  EXPECT_TRUE(Square().input().weights.empty());
}

TEST(InputFromArrays, NamesTheEntryThatIsWrong) {
  Square square;
  square.faces[1] = {0, 9, 3};
  expect_refused([&] { square.input(); }, InputFault::index, "faces[1] names positions[9], but there are 5");
  square = {};
  square.positions[2].y = nan;
  expect_refused([&] { square.input(); }, InputFault::nonfinite, "positions[2] is not finite");
  square.faces.clear();
  expect_refused([&] { square.input(); }, InputFault::nonfinite, "positions[2] is not finite");
  square = {};
  square.positions[1].x = 1e101;
  expect_refused([&] { square.input(); }, InputFault::range, "positions[1]");
  square = {};
  square.weights = {1, -1};
  expect_refused([&] { square.input(); }, InputFault::range, "weights[1]: the weight -1 is not positive");
}

TEST(InputFromArrays, OfWrongLengthsIsRefused) {
  Square square;
  square.weights = {1};
  expect_refused([&] { square.input(); }, InputFault::index, "weights has 1 entries, but faces has 2");
  square = {};
  square.positions.clear(), square.faces.clear();
  expect_refused([&] { square.input(); }, InputFault::empty, "positions is empty");
  square = {};
  square.faces = {{1, 1, 1}};
  expect_refused([&] { square.input(); }, InputFault::degenerate, "no face has three different corners");
  square.faces.clear();
  expect_refused([&] { square.input({.as = InputKind::mesh}); }, InputFault::empty, "faces is empty");
}

TEST(InputFromArrays, RefusesMasksAndWeightsAndColumnsOfFiles) {
  const Square square;
  const std::vector<std::uint8_t> mask(5, 1);
  Arrays arrays = square.arrays();
  arrays.vertex_mask = mask;
  EXPECT_THROW(make_input(arrays), CapabilityError);
  arrays = square.arrays();
  arrays.face_mask = std::span(mask).first(2);
  EXPECT_THROW(make_input(arrays), CapabilityError);
  EXPECT_THROW(square.input({.weights = "w.txt"}), OptionError);
  EXPECT_THROW(square.input({.columns = "1,2,3"}), OptionError);
}

}  // namespace
}  // namespace geodrome::testing
