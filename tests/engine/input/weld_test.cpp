// SPDX-License-Identifier: MIT
// Vertices at the same place but for rounding: welding within a tolerance, and what is told of open edges that lie on
// each other and of coordinates that were rounded to float32.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/input/merge.hpp"
#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

const Finding* finding(const Input& input, const std::string& code) {
  const auto found = std::ranges::find(input.findings, code, &Finding::code);
  return found == input.findings.end() ? nullptr : &*found;
}

struct Grid {
  std::vector<Vec3> positions;
  std::vector<Triangle> faces;

  Input input(const ReadOptions& options = {}) const {
    return make_input({.positions = positions, .faces = faces}, options);
  }
  /// Joins n x m quads, whose corners are made by `at(i, j)`, with vertices of their own.
  template <class At>
  void add(Index n, Index m, At&& at) {
    const auto first = static_cast<Index>(positions.size());
    for (Index j = 0; j <= m; ++j)
      for (Index i = 0; i <= n; ++i) positions.push_back(at(i, j));
    const auto vertex = [&](Index i, Index j) { return first + i + (n + 1) * j; };
    for (Index j = 0; j < m; ++j)
      for (Index i = 0; i < n; ++i) {
        faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
        faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
  }
};

/// A sphere by longitude and latitude whose seam is there twice.
Grid globe() {
  Grid grid;
  grid.add(12, 6, [](Index i, Index j) {
    const double phi = 2 * std::numbers::pi * i / 12, theta = std::numbers::pi * j / 6;
    return Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  });
  return grid;
}

/// Two sheets of 4 x 4 squares that meet at x = 4 but for `gap`.
Grid two_sheets(double gap, double scale = 1) {
  Grid grid;
  grid.add(4, 4, [&](Index i, Index j) { return scale * Vec3{double(i), double(j), 0}; });
  grid.add(4, 4, [&](Index i, Index j) { return scale * Vec3{4.0 + i, double(j), 0} + Vec3{gap, 0, 0}; });
  return grid;
}

TEST(Welding, WithinAToleranceClosesTheSeamOfAGlobe) {
  const Grid grid = globe();
  const Input torn = grid.input({.weld = true});
  EXPECT_GT(torn.facts.boundary_edges, 0u);
  const Input whole = grid.input({.weld = true, .weld_tolerance = 1e-12});
  EXPECT_EQ(whole.facts.boundary_edges, 0u);
  EXPECT_EQ(whole.facts.genus, 0);
  EXPECT_EQ(whole.positions.size(), 12u * 5 + 2);
  EXPECT_EQ(whole.positions[0], grid.positions[0]) << "the first of a place stands for the others";
  EXPECT_EQ(whole.facts.degenerate_faces_dropped, 24u) << "those that collapse at the poles";
  ASSERT_TRUE(finding(whole, "welded_vertices"));
  EXPECT_NE(finding(whole, "welded_vertices")->message.find("within 1e-12, at most"), std::string::npos);
}

TEST(Welding, WithATolerance0IsExact) {
  const Grid grid = globe();
  const Input a = grid.input({.weld = true}), b = grid.input({.weld = true, .weld_tolerance = 0});
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.element_of_row, b.element_of_row);
}

TEST(Welding, IsInUnitsOfTheInput) {
  for (const double scale : {1e-50, 1.0, 1e50}) {
    const Grid grid = two_sheets(1e-3 * scale, scale);
    EXPECT_EQ(grid.input({.weld = true, .weld_tolerance = 0.99e-3 * scale}).facts.components, 2u);
    EXPECT_EQ(grid.input({.weld = true, .weld_tolerance = 1.01e-3 * scale}).facts.components, 1u);
  }
}

TEST(Welding, RefusesAChainThatWouldMoveAVertexFarther) {
  const Grid grid = two_sheets(0.5);
  expect_refused([&] { grid.input({.weld = true, .weld_tolerance = 1.1}); }, InputFault::range,
                 "would move positions[");
  const std::vector<Vec3> chain{{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}};
  const input::MergedWithin within = input::merge_points_within(chain, 1);
  EXPECT_EQ(within.chained, 2u);
  EXPECT_EQ(within.chained_to, 0u);
}

TEST(Welding, JoinsByStepsInWhateverOrderAndMovesNoneFartherThanTheTolerance) {
  const std::vector<Vec3> star{{5, 0, 0}, {0, 0, 0}, {0.9, 0, 0}, {-0.9, 0, 0}, {0, 0, 0}, {5, 0.5, 0}};
  const input::MergedWithin within = input::merge_points_within(star, 1);
  EXPECT_EQ(within.chained, no_index);
  EXPECT_EQ(within.merged.element_of_row, (std::vector<Index>{0, 1, 1, 1, 1, 0}));
  EXPECT_EQ(within.merged.positions, (std::vector<Vec3>{{5, 0, 0}, {0, 0, 0}}));
  EXPECT_DOUBLE_EQ(within.moved, 0.9);
}

TEST(Welding, OfManyVerticesAtOnePlaceIsNotSquared) {
  std::vector<Vec3> crowd;
  for (int i = 0; i < 60000; ++i) crowd.push_back({1e-9 * i, 0, 0});
  EXPECT_EQ(input::merge_points_within(crowd, 1).merged.positions.size(), 1u);
}

TEST(Welding, TakesATolerancesOfANumberThatIsOne) {
  const Grid grid = two_sheets(1e-3);
  for (const double wrong : {-1.0, double{NAN}, double{INFINITY}, 1e200})
    EXPECT_THROW(grid.input({.weld = true, .weld_tolerance = wrong}), OptionError);
  EXPECT_THROW(grid.input({.weld_tolerance = 1e-3}), OptionError) << "without welding";
  expect_refused([&] { grid.input({.as = InputKind::points, .weld = true, .weld_tolerance = 1e-3}); },
                 InputFault::unsupported, "for meshes");
}

TEST(OpenEdges, OnEachOtherWithinRoundingAreToldWithTheToleranceThatJoinsThem) {
  const Grid grid = globe();
  for (const ReadOptions& options : {ReadOptions{}, ReadOptions{.weld = true}}) {
    const Input input = grid.input(options);
    const Finding* told = finding(input, "coincident_edges");
    ASSERT_TRUE(told);
    EXPECT_EQ(told->severity, Finding::Severity::warning);
    EXPECT_EQ(told->remedy.code, "read.weld_within");
    const double tolerance = std::stod(told->remedy.parameters.at(0));
    EXPECT_LT(tolerance, 1e-14);
    EXPECT_EQ(grid.input({.weld = true, .weld_tolerance = tolerance}).facts.boundary_edges, 0u);
  }
}

TEST(OpenEdges, BetweenComponentsSayHowManyThereWouldBe) {
  const Input input = two_sheets(1e-9).input();
  const Finding* told = finding(input, "coincident_edges");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->count, 8u);
  EXPECT_NE(told->message.find("2 components stay apart that would be 1"), std::string::npos) << told->message;
  EXPECT_EQ(two_sheets(1e-9).input({.weld = true, .weld_tolerance = 1e-8}).facts.components, 1u);
}

TEST(OpenEdges, AtExactlyTheSamePlaceAreToldIfComponentsWouldBeJoined) {
  const Input input = two_sheets(0).input();
  const Finding* told = finding(input, "coincident_edges");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->remedy.code, "read.weld");
  Grid ring;  // one component, torn at a seam
  ring.add(12, 1, [](Index i, Index j) {
    const double phi = 2 * std::numbers::pi * (i % 12) / 12;
    return Vec3{std::cos(phi), std::sin(phi), double(j)};
  });
  EXPECT_FALSE(finding(ring.input(), "coincident_edges")) << "the equal positions are told, and that is enough";
  EXPECT_TRUE(finding(ring.input(), "duplicate_positions"));
}

TEST(OpenEdges, OfManyTrianglesAroundAPointAreNotSquared) {
  Grid fan;  // every triangle has corners of its own, all with the apex but for rounding
  for (Index k = 0; k < 40000; ++k) {
    const auto rim = [](double t) { return Vec3{std::cos(t), std::sin(t), 0}; };
    const double step = 2 * std::numbers::pi / 40000;
    fan.positions.insert(fan.positions.end(), {{0, 0, 1e-13 * k}, rim(k * step), rim((k + 1) * step)});
    fan.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const Input input = fan.input();
  ASSERT_TRUE(finding(input, "coincident_edges"));
  EXPECT_EQ(finding(input, "coincident_edges")->count, 80000u);
}

TEST(OpenEdges, AlongALongerOneAreToldThoughNoWeldingJoinsThem) {
  Grid sheets;  // the second has two edges for each of the first
  sheets.add(4, 4, [](Index i, Index j) { return Vec3{0.3 * i, 0.3 * j, 0.1 * i}; });
  sheets.add(4, 8, [](Index i, Index j) { return Vec3{1.2 + 0.3 * i, 0.15 * j, 0.4 - 0.1 * i}; });
  const Input input = sheets.input();
  EXPECT_FALSE(finding(input, "coincident_edges"));
  const Finding* told = finding(input, "edges_along_edges");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->count, 8u);
  EXPECT_NE(told->message.find("2 components stay apart that would be 1"), std::string::npos) << told->message;
  EXPECT_EQ(told->remedy.code, "") << "no welding";
}

TEST(OpenEdges, OfManySpikesAroundAPointAreNotSquared) {
  Grid star;  // all with one apex, each with sides of its own
  star.positions.push_back({0, 0, 0});
  for (Index k = 0; k < 60000; ++k) {
    const auto rim = [](double t) { return Vec3{std::cos(t), std::sin(t), 0.1}; };
    const double step = 2 * std::numbers::pi / 60000;
    star.positions.insert(star.positions.end(), {rim(k * step), rim((k + 0.5) * step)});
    star.faces.push_back({0, 2 * k + 1, 2 * k + 2});
  }
  const Input input = star.input();
  EXPECT_FALSE(finding(input, "coincident_edges"));
  EXPECT_FALSE(finding(input, "edges_along_edges"));
}

TEST(OpenEdges, ApartAreNotTold) {
  for (const double gap : {1e-3, 0.1, 1.0}) EXPECT_FALSE(finding(two_sheets(gap).input(), "coincident_edges")) << gap;
  Grid corner_to_corner = two_sheets(0);
  for (std::size_t v = 25; v < 50; ++v) corner_to_corner.positions[v].y += 4 + 1e-9;
  EXPECT_FALSE(finding(corner_to_corner.input(), "coincident_edges")) << "they meet at a corner, along no edge";
  EXPECT_FALSE(finding(corner_to_corner.input(), "edges_along_edges"));
}

TEST(OpenEdges, AreFoundInSixPrintedDigitsAndInFloats) {
  Grid printed = two_sheets(2e-6, 0.7);
  EXPECT_TRUE(finding(printed.input(), "coincident_edges"));
  Grid utm;
  const auto at = [](double x, double y) { return Vec3{float(512434 + x), float(5405590 + y), 100}; };
  utm.add(4, 4, [&](Index i, Index j) { return at(20.0 * i, 20.0 * j); });
  utm.add(4, 4, [&](Index i, Index j) { return at(80 + 20.0 * i, 20.0 * j + 0.4); });
  EXPECT_TRUE(finding(utm.input(), "coincident_edges")) << "half a metre is one step of float32 there";
}

/// 15 x 15 vertices on a wavy sheet.
Grid sheet(double x, double y, double spacing) {
  Grid grid;
  grid.add(14, 14, [&](Index i, Index j) {
    return Vec3{x + spacing * i, y + spacing * j, 100 + spacing * std::sin(0.7 * i + 0.4 * j)};
  });
  return grid;
}

Grid as_floats(Grid grid) {
  for (Vec3& p : grid.positions) p = {float(p.x), float(p.y), float(p.z)};
  return grid;
}

TEST(Float32, StepsFarFromTheOriginAreToldAgainstTheSpacing) {
  const Grid rounded = as_floats(sheet(512434.3, 5405590.1, 0.83));
  const Input mesh = rounded.input();
  const Finding* told = finding(mesh, "float32_steps");
  ASSERT_TRUE(told);
  EXPECT_NE(told->message.find("in steps of 0.5"), std::string::npos) << told->message;
  const Input cloud = rounded.input({.as = InputKind::points});
  ASSERT_TRUE(finding(cloud, "float32_steps"));
  EXPECT_NE(finding(cloud, "float32_steps")->message.find("spacing of the points"), std::string::npos);
}

TEST(Float32, StepsThatAreSmallOrWereNotRoundedToAreNotTold) {
  EXPECT_FALSE(finding(sheet(512434.3, 5405590.1, 0.83).input(), "float32_steps")) << "doubles";
  EXPECT_FALSE(finding(as_floats(sheet(0.3, 0.1, 0.83)).input(), "float32_steps")) << "at the origin";
  EXPECT_FALSE(finding(as_floats(sheet(512434.3, 5405590.1, 30)).input(), "float32_steps")) << "60 steps to an edge";
  Grid metres;  // a raster in whole metres, which floats hold exactly
  metres.add(14, 14, [](Index i, Index j) { return Vec3{512434.0 + i, 5405590.0 + j, double((i * j) % 7)}; });
  EXPECT_FALSE(finding(metres.input(), "float32_steps"));
}

}  // namespace
}  // namespace geodrome::testing
