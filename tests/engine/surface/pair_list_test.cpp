// SPDX-License-Identifier: MIT
// Files of pairs: what they may say and how mistakes are told.
#include <gtest/gtest.h>

#include "geodrome/engine/named_points.hpp"
#include "tests/support/input_files.hpp"
#include "tests/support/program.hpp"

namespace geodrome::testing {
namespace {

PlacedSurface surface_of(const Input& input) {
  Observer silent;
  return make_surface(input, PluginHost(), {}, silent);
}

/// Two triangles of the unit square, and a vertex on no face.
class PairFiles : public ::testing::Test {
 protected:
  PairList read(const std::string& text) const {
    write_bytes(file_, text);
    return select_pairs(file_, input_, surface_);
  }
  void expect_error(const std::string& line, const std::string& part) const {
    const auto attempt = [&] { read("0, 1\n\n" + line + "\n"); };
    expect_refused(attempt, InputFault::syntax, part);
    expect_refused(attempt, InputFault::syntax, "p.txt: line 3");
    const auto error = error_of(attempt);
    ASSERT_TRUE(error);
    EXPECT_FALSE(error->remedy().empty()) << error->what();
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "p.txt";
  const Input input_ =
      testing::read_bytes("square.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 2 3\n");
  const PlacedSurface surface_ = surface_of(input_);
};

TEST_F(PairFiles, NameRowsAndPointsOnEitherSide) {
  const auto pairs = read("3, 1\n0 0.2 0.3 0.5, 0.5 0.25 7\n  0.5 0 0 ,2\n").pairs;
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].from.row, 3u);
  EXPECT_EQ(pairs[0].to.row, 1u);
  EXPECT_EQ(pairs[0].from.label, "3");
  EXPECT_EQ(pairs[1].from.place.at, (SurfacePoint{0, {0.2, 0.3, 0.5}}));
  EXPECT_EQ(pairs[1].from.label, "0 0.2 0.3 0.5");
  EXPECT_EQ(pairs[1].to.place.position, (Vec3{0.5, 0.25, 0})) << "the closest point of the mesh";
  EXPECT_EQ(pairs[2].from.label, "0.5 0 0");
  EXPECT_EQ(pairs[2].to.place.vertex, 2u);
}

TEST_F(PairFiles, MayHaveCommentsBlankLinesAndWindowsLineEnds) {
  const auto pairs = read("\xEF\xBB\xBF# pairs, with a comma\r\n\r\n0,1 # near\r\n\t2\t,\t3\t\r\n4, 4").pairs;
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[1].to.row, 3u);
  EXPECT_EQ(pairs[2].from.place.state, Place::State::isolated);
}

TEST_F(PairFiles, MayBeRowsAsNumpyWritesThem) {
  const auto pairs = read("0.000e+00 3.000e+00\n1.000e+00,2.000e+00\n").pairs;
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].from.row, 0u);
  EXPECT_EQ(pairs[0].to.row, 3u);
  EXPECT_EQ(pairs[1].to.label, "2");
}

TEST_F(PairFiles, HaveOnePointAtEachEnd) {
  expect_error("0-1, 3", "'0-1' names 2 rows");
  expect_error("0, 0:4:2", "'0:4:2' names 2 rows");
  EXPECT_EQ(read("0, 3-3").pairs[0].to.row, 3u);
}

TEST_F(PairFiles, MeasureHowFarAnEndIsOffTheSurface) {
  EXPECT_EQ(read("0, 0.5 0.25 7").pairs[0].to.off_surface, 7);
  EXPECT_EQ(read("0 0.2 0.3 0.5, 4").pairs[0].from.off_surface, 0);
}

TEST_F(PairFiles, AreToldApartByTheirHash) {
  EXPECT_EQ(read("0,1").hash, read("0,1").hash);
  EXPECT_NE(read("0,1").hash, read("0,2").hash);
}

TEST_F(PairFiles, OfOneEntryOrThreeNameFileAndLine) {
  for (const std::string line : {"0", "0; 1", "0, 1, 2", "0,5 0 0, 1", "0 1 2", ","}) expect_error(line, "'i, j'");
}

TEST_F(PairFiles, WithAnEntryThatIsNoneNameIt) {
  expect_error("0, 1 2", "'1 2'");
  expect_error("0,", "'i, j'");
  expect_error("-1, 0", "'-1'");
  expect_error("0, 5", "row 5 does not exist");
  expect_error("0, x", "'x'");
  expect_error("0, nan 0 0", "'nan'");
  expect_error("7 0.2 0.3 0.5, 0", "face 7 does not exist");
}

TEST_F(PairFiles, WithBarycentricCoordinatesThatAreNone) {
  const auto attempt = [&] { read("0 0.5 0.5 0.5, 0"); };
  expect_refused(attempt, InputFault::syntax, "p.txt: line 1: barycentric coordinates");
}

TEST_F(PairFiles, WithAStartDistanceSayThatPairsHaveNone) { expect_error("0, 1 + 2", "start distance"); }

TEST_F(PairFiles, ThatAreMissingOrNameNoPair) {
  expect_refused([&] { select_pairs(folder_ / "no.txt", input_, surface_); }, InputFault::io, "no.txt");
  expect_refused([&] { read("# nothing\n\n"); }, InputFault::empty, "names no pair");
  expect_refused([&] { read(""); }, InputFault::empty, "0 bytes");
}

}  // namespace
}  // namespace geodrome::testing
