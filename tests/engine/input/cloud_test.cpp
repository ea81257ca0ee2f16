// SPDX-License-Identifier: MIT
#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

TEST(InputCloud, CommentsBlankLinesAndFurtherColumnsAreAccepted) {
  const Input input = read_bytes("p.xyz", "# x y z nx ny nz\n\n1 2 3 0 0 1\r\n  4\t5 6 0 0 1 # last\n");
  EXPECT_EQ(input.kind, InputKind::points);
  EXPECT_EQ(input.positions, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(InputCloud, LinesOfDifferentLengthAreRefused) {
  expect_refused([] { read_bytes("p.xyz", "1 2 3 4\n1 2 3\n"); }, InputFault::syntax, "line 2");
}

TEST(InputCloud, TwoColumnsAreRefused) {
  expect_refused([] { read_bytes("p.xyz", "1 2\n3 4\n"); }, InputFault::syntax, "line 1");
}

TEST(InputCloud, OnlyCommentsAreEmpty) {
  expect_refused([] { read_bytes("p.xyz", "# nothing\n\n"); }, InputFault::empty, "no points");
}

TEST(InputCloud, ExactDuplicatesAreMergedIntoTheFirst) {
  const Input input = read_bytes("p.xyz", "5 0 0\n1 0 0\n5 0 0\n0 0 0\n1 0 0\n");
  EXPECT_EQ(input.positions, (std::vector<Vec3>{{5, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
  EXPECT_EQ(input.element_of_row, (std::vector<Index>{0, 1, 0, 2, 1}));
  EXPECT_EQ(input.facts.merged, 2u);
  ASSERT_TRUE(has_finding(input, "merged_points"));
  EXPECT_EQ(input.findings[0].elements, (std::vector<Index>{2, 4}));
}

TEST(InputCloud, MinusZeroIsTheSamePlaceAsZero) {
  EXPECT_EQ(read_bytes("p.xyz", "0 0 0\n-0 0 -0.0\n").positions.size(), 1u);
}

TEST(InputCloud, NeighbouringDoublesStayApart) {
  EXPECT_EQ(read_bytes("p.xyz", "1 0 0\n1.0000000000000002 0 0\n").positions.size(), 2u);
}

TEST(InputCloud, DroppedRowsComeBeforeMergingAndKeepTheirPlace) {
  const Input input = read_bytes("p.xyz", "nan 0 0\n1 0 0\n0 inf 0\n1 0 0\n2 0 0\n", {.drop_nonfinite = true});
  EXPECT_EQ(input.element_of_row, (std::vector<Index>{no_index, 0, no_index, 0, 1}));
  EXPECT_EQ(input.facts.dropped, 2u);
  EXPECT_EQ(input.facts.merged, 1u);
}

TEST(InputCloud, DroppingEveryPointLeavesNothing) {
  expect_refused([] { read_bytes("p.xyz", "nan 0 0\n", {.drop_nonfinite = true}); }, InputFault::empty, "no points");
}

TEST(InputCloud, AMeshReadAsPointsGivesAllItsVerticesAndSaysSo) {
  const Input input =
      read_bytes("m.off", "OFF\n4 1 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n", {.as = InputKind::points});
  EXPECT_EQ(input.kind, InputKind::points);
  EXPECT_EQ(input.positions.size(), 4u);
  EXPECT_TRUE(input.triangles.empty());
  EXPECT_TRUE(has_finding(input, "faces_not_used"));
}

TEST(InputCloud, NumbersBeyondDoubleAreOutOfRange) {
  expect_refused([] { read_bytes("p.xyz", "0 0 0\n1e400 0 0\n"); }, InputFault::range, "line 2");
}

TEST(InputCloud, NumbersBelowDoubleAreZero) {
  EXPECT_EQ(read_bytes("p.xyz", "1e-400 1 1e-9999\n").positions[0], (Vec3{0, 1, 0}));
}

TEST(InputCloud, ExtentsOutOfReachAreRefused) {
  expect_refused([] { read_bytes("p.xyz", "0 0 0\n1e101 0 0\n"); }, InputFault::range, "rescale");
  expect_refused([] { read_bytes("p.xyz", "0 0 0\n1e-101 0 0\n"); }, InputFault::range, "rescale");
  expect_refused([] { read_bytes("p.xyz", "nan 0 0\n0 0 0\n1e101 0 0\n", {.drop_nonfinite = true}); },
                 InputFault::range, "point 2 (from 0)");
}

}  // namespace
}  // namespace geodrome::testing
