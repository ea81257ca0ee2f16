// SPDX-License-Identifier: MIT
// Lists of points: rows, ranges of rows, points and places on faces; and what is told of points off the surface.
#include "engine/surface/selection.hpp"

#include <gtest/gtest.h>

#include "engine/search/named_points.hpp"
#include "engine/surface/off_surface.hpp"
#include "tests/support/input_files.hpp"
#include "tests/support/program.hpp"

namespace geodrome::testing {
namespace {

/// Two triangles of the unit square and a far vertex on no face, which has no part in the surface's diagonal.
class Lists : public ::testing::Test {
 protected:
  static Input square() {
    return testing::read_bytes("square.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n900 0 0\n3 0 1 2\n3 1 2 3\n");
  }
  static PlacedSurface surface_of(const Input& input) {
    Observer silent;
    return make_surface(input, PluginHost(), {}, silent);
  }
  std::vector<NamedPoint> points(const std::string& list) const { return select(list, input_, surface_); }
  std::vector<NamedPoint> file(const std::string& text) const {
    write_bytes(folder_ / "l.txt", text);
    return points("@" + (folder_ / "l.txt").string());
  }
  std::vector<Index> rows(const std::vector<NamedPoint>& points) const {
    std::vector<Index> rows;
    for (const NamedPoint& point : points) rows.push_back(point.row);
    return rows;
  }
  template <class Read>
  void expect_error(Read&& read, const std::string& part) const {
    try {
      read();
      ADD_FAILURE() << "was accepted: " << part;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  OffSurface off(const std::string& text) const {
    write_bytes(folder_ / "l.txt", text);
    const Selection selection = parse_selection("@" + (folder_ / "l.txt").string());
    OffSurfaceFinder finder(input_, surface_);
    finder.add(selection, resolve(selection, input_, surface_));
    return finder.found();
  }

  const TemporaryFolder folder_;
  const Input input_ = square();
  const PlacedSurface surface_ = surface_of(input_);
};

using Rows = std::vector<Index>;

TEST_F(Lists, HoldRangesWithAndWithoutTheirEnd) {
  EXPECT_EQ(rows(points("1-3")), (Rows{1, 2, 3}));
  EXPECT_EQ(rows(points("1:3")), (Rows{1, 2}));
  EXPECT_EQ(rows(points("0:5:2")), (Rows{0, 2, 4}));
  EXPECT_EQ(rows(points("0:4:3,2-2")), (Rows{0, 3, 2}));
  EXPECT_EQ(rows(points("1:100:99")), Rows{1}) << "an end that no row reaches";
  EXPECT_EQ(rows(file("1-2\n0:5:4\n")), (Rows{1, 2, 0, 4}));
}

TEST_F(Lists, MayHaveBlanksAroundCommas) { EXPECT_EQ(rows(points("0, 1 ,2-3")), (Rows{0, 1, 2, 3})); }

TEST_F(Lists, KeepWhatIsNamedTwice) {
  EXPECT_EQ(rows(points("1,1")), (Rows{1, 1}));
  EXPECT_EQ(rows(points("0-2,1-3")), (Rows{0, 1, 2, 1, 2, 3}));
}

TEST_F(Lists, TakeWholeNumbersAsNumpyWritesThem) {
  EXPECT_EQ(rows(file("0.000000000000000000e+00\n3.000000000000000000e+00\n")), (Rows{0, 3}));
  EXPECT_EQ(file("1.000e+00 0.0e+00 4.0e-01 6.0e-01\n")[0].place.at, (SurfacePoint{1, {0, 0.4, 0.6}}));
  for (const std::string word : {"1.5", "1e-5", "-1", "+1", "nan", "inf", "1e300", "99999999999999999999", ""})
    expect_error([&] { points(word + ",0"); }, "is not the index of a row");
}

TEST_F(Lists, RefuseRangesThatNameNoRowOrRowsThatAreNotThere) {
  for (const std::string range : {"3-1", "2:2", "3:1", "0:4:0"})
    expect_error([&] { points(range); }, "'" + range + "' names no row");
  for (const std::string range : {"0:x", "0:1:2:3", ":", "a:b", "1:-1"})
    expect_error([&] { points(range); }, "is no range of rows");
  expect_error([&] { points("0-5"); }, "row 5 does not exist");
  expect_error([&] { file("0\n0:100:10\n"); }, "line 2: row 90 does not exist");
}

TEST_F(Lists, RefuseHugeRangesBeforeTheyTakeMemory) {
  expect_error([&] { points("0-4000000000"); }, "row 4000000000 does not exist; there are 5");
  expect_error([&] { points("0-4294967295"); }, "beyond the last row");
  expect_error([&] { points("0-18446744073709551615"); }, "beyond the last row");
  expect_error([&] { points("0:18446744073709551615:3"); }, "beyond the last row");
}

TEST_F(Lists, NamePointsWithBlanksBetweenTheirNumbers) {
  const auto named = points("0.5 0.25 0, 3, 1 0.2 0.3 0.5 + 2");
  ASSERT_EQ(named.size(), 3u);
  EXPECT_EQ(named[0].place.position, (Vec3{0.5, 0.25, 0}));
  EXPECT_EQ(named[0].label, "0.5 0.25 0");
  EXPECT_EQ(named[1].row, 3u);
  EXPECT_EQ(named[2].place.at, (SurfacePoint{1, {0.2, 0.3, 0.5}}));
  EXPECT_EQ(named[2].start, 2);
}

TEST_F(Lists, RefuseThreeRowsWithoutCommasBesideALine) {
  expect_error([&] { points("0 1 2"); }, "write rows as 0,1,2, and a point as 0.0 1 2");
  EXPECT_EQ(points("0.0 1 0").size(), 1u);
}

TEST_F(Lists, RefuseCommasOnALineOfAFile) {
  expect_error([&] { file("0, 1, 2\n"); }, "line 1: there is a comma");
  expect_error([&] { file("0\n0.1,0.2,0.3\n"); }, "line 2: there is a comma");
}

TEST_F(Lists, TakeBarycentricCoordinatesThatAreNegativeByRoundingFor0) {
  EXPECT_EQ(file("1 -5.6e-17 0.4 0.6")[0].place.at, (SurfacePoint{1, {0, 0.4, 0.6}}));
  const SurfacePoint at = file("0 1.0000000005 -5e-10 0")[0].place.at;
  EXPECT_EQ(at, (SurfacePoint{0, {1, 0, 0}}));
  expect_error([&] { file("0 -2e-9 0.5 0.500000002"); }, "barycentric coordinates");
  expect_error([&] { file("0 -0.1 0.6 0.5"); }, "barycentric coordinates");
}

TEST_F(Lists, RefuseNumbersBeyondTheRangeOfInputs) {
  expect_error([&] { file("1e200 0 0"); }, "beyond 1e100");
  expect_error([&] { file("0 + 1.797e308"); }, "beyond 1e100");
}

TEST_F(Lists, OfOnePlaceMayHaveCommasBetweenItsNumbers) {
  EXPECT_EQ(parse_place("0.1,0.2,0.3").entries[0].numbers, (std::array{0.1, 0.2, 0.3}));
  EXPECT_EQ(parse_place("0, 1, 2").entries[0].label, "0 1 2");
  EXPECT_EQ(parse_place("1,0.2,0.3,0.5").entries[0].kind, PointEntry::Kind::on_face);
  EXPECT_EQ(parse_place("3").entries[0].index, 3u);
  EXPECT_EQ(parse_place("0,1").count(), 2u);
  EXPECT_EQ(parse_place("0-9").count(), 10u);
}

TEST_F(Lists, MeasureHowFarAPointIsOffTheSurface) {
  EXPECT_EQ(points("0.5 0.5 0.0")[0].off_surface, 0);
  EXPECT_EQ(points("0.5 0.5 1e-6")[0].off_surface, 0) << "six printed digits";
  EXPECT_DOUBLE_EQ(points("0.5 0.5 0.01")[0].off_surface, 0.01);
  EXPECT_DOUBLE_EQ(points("0.5 0.5 -3")[0].off_surface, 3);
  EXPECT_EQ(points("4")[0].off_surface, 0) << "a row is where it is";
}

TEST_F(Lists, TakeRoundingFarFromTheOriginForNone) {
  const Input input =
      testing::read_bytes("far.off", "OFF\n3 1 0\n5405590 0 0\n5405590.0001 0 0\n5405590 0.0001 0\n3 0 1 2\n");
  const PlacedSurface surface = surface_of(input);
  EXPECT_EQ(select("5405590.00002 0.00002 1e-9", input, surface)[0].off_surface, 0);
  EXPECT_EQ(select("5405590.00002 0.00002 1e-7", input, surface)[0].off_surface, 1e-7);
}

TEST_F(Lists, WarnOfPointsOffTheSurfaceByMoreThanAHundredthOfItsDiagonal) {
  const OffSurface found = off("0\n0.5 0.5 0\n0.5 0.5 0.0142\n0.5 0.5 0.0141\n0.5 0.5 4\n");
  EXPECT_DOUBLE_EQ(found.diagonal, std::sqrt(2)) << "without the vertex on no face";
  EXPECT_EQ(found.named, 4u);
  EXPECT_EQ(found.off, 3u);
  EXPECT_EQ(found.warned, 2u);
  EXPECT_EQ(found.warned_as_rows, 0u);
  ASSERT_EQ(found.farthest.size(), 3u);
  EXPECT_NE(found.farthest[0].entry.find("l.txt: line 5"), std::string::npos);
  EXPECT_DOUBLE_EQ(found.farthest[1].distance, 0.0142);
}

TEST_F(Lists, TellPointsThatCouldBeRows) {
  EXPECT_EQ(off("0 1 2\n").warned_as_rows, 1u);
  EXPECT_EQ(off("0.000e+00 1.000e+00 2.000e+00\n").warned_as_rows, 1u);
  EXPECT_EQ(off("0 1 0\n").warned_as_rows, 0u) << "it lies on the surface";
  EXPECT_EQ(off("0 1 5\n").warned_as_rows, 0u) << "row 5 is not there";
  EXPECT_EQ(off("0 1 2.5\n").warned_as_rows, 0u);
}

TEST_F(Lists, KeepTheTenFarthest) {
  std::string text;
  for (int i = 1; i <= 30; ++i) text += "0.5 0.5 " + std::to_string((i * 7) % 31) + "\n";
  const OffSurface found = off(text);
  EXPECT_EQ(found.warned, 30u);
  ASSERT_EQ(found.farthest.size(), 10u);
  for (int i = 0; i < 10; ++i) EXPECT_DOUBLE_EQ(found.farthest[static_cast<std::size_t>(i)].distance, 30 - i);
}

}  // namespace
}  // namespace geodrome::testing
