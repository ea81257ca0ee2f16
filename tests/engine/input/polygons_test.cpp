// SPDX-License-Identifier: MIT
#include <random>

#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

// One face over all the points.
Input read_polygon(const std::string& points, int corners) {
  std::string text = "OFF\n";
  text += std::to_string(corners);
  text += " 1 0\n";
  text += points;
  text += std::to_string(corners);
  for (int i = 0; i < corners; ++i) {
    text += ' ';
    text += std::to_string(i);
  }
  text += '\n';
  return read_bytes("p.off", text);
}

double area(const Input& input) {
  double sum = 0;
  for (const auto& [a, b, c] : input.triangles)
    sum += norm(cross(input.positions[b] - input.positions[a], input.positions[c] - input.positions[a])) / 2;
  return sum;
}

TEST(InputPolygons, ConvexOnesAreFansFromTheFirstCorner) {
  const Input input = read_polygon("0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n", 5);
  EXPECT_EQ(input.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(input.face_of_triangle, (std::vector<Index>{0, 0, 0}));
  EXPECT_EQ(input.facts.polygons_split, 1u);
  EXPECT_FALSE(has_warning(input));
}

TEST(InputPolygons, AConcaveQuadIsSplitInside) {
  const Input input = read_polygon("0 0 0\n4 0 0\n1 1 0\n0 4 0\n", 4);
  EXPECT_NEAR(area(input), 4, 1e-12);
}

TEST(InputPolygons, ConcaveQuadsInAnyPlaceKeepTheirArea) {
  std::mt19937_64 random(5);
  const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
  for (int round = 0; round < 100; ++round) {
    const Vec3 u{unit(), unit(), unit() + 1}, v{unit() + 1, unit(), -unit()}, o{100 * unit(), unit(), unit()};
    const std::vector<Vec3> corners = {o, o + 4 * u, o + u + v, o + 4 * v};  // area 4 |u x v|
    std::string points;
    char line[128];
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& p = corners[(i + round) % 4];
      std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
      points += line;
    }
    const Input input = read_polygon(points, 4);
    EXPECT_NEAR(area(input), 4 * norm(cross(u, v)), 1e-9);
    EXPECT_FALSE(has_finding(input, "nonplanar_polygons"));
  }
}

TEST(InputPolygons, CollinearCornersGiveNoFlatTriangleWhereThatCanBe) {
  const Input input = read_polygon("0 0 0\n1 0 0\n2 0 0\n1 2 0\n", 4);
  EXPECT_EQ(input.facts.zero_area_faces, 0u);
  EXPECT_NEAR(area(input), 2, 1e-12);
}

TEST(InputPolygons, APolygonThatNoCornerSeesIsSplitInside) {
  // A comb with three teeth.
  const Input input = read_polygon("0 0 0\n9 0 0\n9 5 0\n8 1 0\n5 1 0\n4.5 5 0\n4 1 0\n1 1 0\n0 5 0\n", 9);
  EXPECT_EQ(input.triangles.size(), 7u);
  EXPECT_NEAR(area(input), 9 + 2 * 2 + 2, 1e-12);
}

TEST(InputPolygons, APolygonThatCrossesItselfIsUnsupported) {
  expect_refused([] { read_polygon("0 3 0\n2 -3 0\n-3 1 0\n3 1 0\n-2 -3 0\n", 5); }, InputFault::unsupported, "face 0");
}

TEST(InputPolygons, NonplanarOnesAreTold) {
  EXPECT_TRUE(has_finding(read_polygon("0 0 0\n1 0 0\n1 1 0.3\n0 1 0\n", 4), "nonplanar_polygons"));
}

TEST(InputPolygons, ACornerNamedTwiceInARowIsJoined) {
  const Input input = read_bytes("p.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n5 0 1 1 2 0\n");
  EXPECT_EQ(input.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_TRUE(has_finding(input, "repeated_corners"));
}

TEST(InputPolygons, APolygonThatComesBackToACornerIsUnsupported) {
  expect_refused([] { read_bytes("p.off", "OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n6 0 1 2 0 3 4\n"); },
                 InputFault::unsupported, "face 0");
}

}  // namespace
}  // namespace geodrome::testing
