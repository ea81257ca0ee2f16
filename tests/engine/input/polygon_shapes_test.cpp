// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <map>
#include <random>

#include "tests/support/input_files.hpp"

// Polygons that no corner sees all of, and polygons with holes: whatever their shape, triangles of them cover what they
// cover, along their edges, and do not depend on where they begin or how they lie in space.
namespace geodrome::testing {
namespace {

using Corners = std::vector<Vec3>;

struct Face {
  Corners positions;
  std::vector<Index> corners;
};

Face whole(Corners positions) {
  Face face{std::move(positions), {}};
  for (Index i = 0; i < face.positions.size(); ++i) face.corners.push_back(i);
  return face;
}

Input read_face(const Face& face) {
  std::string text = "OFF\n" + std::to_string(face.positions.size()) + " 1 0\n";
  for (const Vec3& p : face.positions) {
    char line[128];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
    text += line;
  }
  text += std::to_string(face.corners.size());
  for (const Index corner : face.corners) text += " " + std::to_string(corner);
  return read_bytes("p.off", text + "\n");
}

Vec3 doubled_area(const Face& face) {
  Vec3 sum;
  for (std::size_t i = 0; i < face.corners.size(); ++i)
    sum = sum + cross(face.positions[face.corners[i]], face.positions[face.corners[(i + 1) % face.corners.size()]]);
  return sum;
}

double area_of(const Input& input) {
  double sum = 0;
  for (const auto& [a, b, c] : input.triangles)
    sum += norm(cross(input.positions[b] - input.positions[a], input.positions[c] - input.positions[a])) / 2;
  return sum;
}

/// Triangles whatever their order and first corner.
std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  std::ranges::sort(triangles);
  return triangles;
}

/// Expects n - 2 triangles that cover the face once, with its edges as their border.
void expect_covers(const Input& input, const Face& face) {
  ASSERT_EQ(input.triangles.size(), face.corners.size() - 2);
  const double area = norm(doubled_area(face)) / 2;
  EXPECT_NEAR(area_of(input), area, 1e-9 * area);
  std::map<std::pair<Index, Index>, int> passed;
  for (const Triangle& t : input.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++passed[{t[i], t[(i + 1) % 3]}], --passed[{t[(i + 1) % 3], t[i]}];
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Index from = face.corners[i], to = face.corners[(i + 1) % face.corners.size()];
    --passed[{from, to}], ++passed[{to, from}];
  }
  for (const auto& [edge, count] : passed) EXPECT_EQ(count, 0) << edge.first << " " << edge.second;
}

void expect_refused_face(const Face& face) {
  SCOPED_TRACE(::testing::PrintToString(face.corners));
  expect_refused([&] { read_face(face); }, InputFault::unsupported, "face 0");
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_;
};

double side(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a).z; }

bool cross_each_other(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// A simple polygon through random points: crossing edges are turned round until there are none.
Face random_polygon(Random& random, std::size_t n) {
  Corners p(n);
  for (Vec3& corner : p) corner = {random.unit(), random.unit(), 0};
  for (bool crossed = true; crossed;) {
    crossed = false;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j)
        if (cross_each_other(p[i], p[i + 1], p[j], p[(j + 1) % n])) {
          std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          crossed = true;
        }
  }
  return whole(p);
}

/// The same face elsewhere in space.
Face moved(Random& random, Face face) {
  Vec3 u{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
  u = u / norm(u);
  Vec3 v = cross(u, {random.unit(), random.unit() + 1, random.unit()});
  v = v / norm(v);
  const Vec3 w = cross(u, v), o{random.unit(), 10 * random.unit(), -random.unit()};
  for (Vec3& p : face.positions) p = o + p.x * u + p.y * v + p.z * w;
  return face;
}

Face comb(int teeth) {
  Corners p;
  for (int i = 0; i < teeth; ++i)
    p.insert(p.end(), {{2. * i, 5, 0}, {2. * i, 1, 0}, {2. * i + 1, 1, 0}, {2. * i + 1, 5, 0}});
  p.insert(p.end(), {{2. * teeth, 5, 0}, {2. * teeth, 0, 0}, {-1, 0, 0}, {-1, 5, 0}});
  return whole(p);
}

Face spiral(int turns) {
  Corners out, back;
  for (int i = 0; i < 4 * turns; ++i) {
    const double r = 2 + i, angle = i % 4;
    const double x = angle == 0 || angle == 3 ? r : -r, y = angle < 2 ? r : -r;
    out.push_back({x, y, 0});
    back.push_back({x * (1 - 0.4 / r), y * (1 - 0.4 / r), 0});
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  return whole(out);
}

Face with_corners_on_edges(const Face& face, int on_each) {
  Corners p;
  for (std::size_t i = 0; i < face.positions.size(); ++i) {
    const Vec3 &from = face.positions[i], &to = face.positions[(i + 1) % face.positions.size()];
    for (int k = 0; k <= on_each; ++k) p.push_back(from + (double(k) / (on_each + 1)) * (to - from));
  }
  return whole(p);
}

const Corners letter_u = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
/// A square with a square hole, and a bridge between the corners 0 and 4.
const Face with_hole = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}},
                        {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}};

void expect_covers_however_it_lies(const Face& face, Random& random, bool same_triangles = true) {
  const std::vector<Triangle> triangles = sorted(read_face(face).triangles);
  Face turned = face;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    std::rotate(turned.corners.begin(), turned.corners.begin() + 1, turned.corners.end());
    const Input input = read_face(turned);
    expect_covers(input, turned);
    if (same_triangles) {
      EXPECT_EQ(sorted(input.triangles), triangles);
    }
  }
  std::ranges::reverse(turned.corners);
  expect_covers(read_face(turned), turned);
  const Face elsewhere = moved(random, face);
  const Input there = read_face(elsewhere);
  expect_covers(there, elsewhere);
  if (same_triangles) {
    EXPECT_EQ(sorted(there.triangles), triangles);
  }
  EXPECT_FALSE(has_finding(there, "nonplanar_polygons"));
  EXPECT_FALSE(has_finding(there, "zero_area_faces"));
}

TEST(InputPolygonShapes, CombsAndSpiralsAndLetters) {
  Random random(1);
  expect_covers_however_it_lies(whole(letter_u), random);
  for (const int size : {2, 3, 8}) {
    expect_covers_however_it_lies(comb(size), random);
    expect_covers_however_it_lies(spiral(size), random);
  }
}

TEST(InputPolygonShapes, CornersWithinEdges) {
  Random random(2);
  for (const int more : {1, 2, 5}) {
    expect_covers_however_it_lies(with_corners_on_edges(whole(letter_u), more), random);
    expect_covers_however_it_lies(with_corners_on_edges(comb(2), more), random);
  }
}

TEST(InputPolygonShapes, RandomSimplePolygons) {
  Random random(3);
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE(round);
    const Face face = random_polygon(random, 4 + random.below(30));
    // Stars are fans from the first corner that sees all of them.
    const bool is_star = read_face(face).triangles[0][0] == read_face(face).triangles.back()[0];
    expect_covers_however_it_lies(face, random, !is_star);
  }
}

TEST(InputPolygonShapes, BridgesToHoles) {
  Random random(4);
  expect_covers_however_it_lies(with_hole, random);
  // Two holes, one after the other, and one behind the other.
  Face two = with_hole;
  two.positions.insert(two.positions.end(), {{3, 3, 0}, {3, 3.7, 0}, {3.3, 3.5, 0}});
  two.corners = {0, 1, 2, 8, 9, 10, 8, 2, 3, 0, 4, 5, 6, 7, 4};
  expect_covers_however_it_lies(two, random);
  two.corners = {0, 1, 2, 3, 0, 4, 5, 6, 8, 9, 10, 8, 6, 7, 4};
  expect_covers_however_it_lies(two, random);
  // A slit, with a corner at its end.
  Face slit = whole({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 3, 0}});
  slit.corners.push_back(3);
  expect_covers_however_it_lies(slit, random);
  // A bridge of two edges.
  Face bent = with_hole;
  bent.positions.push_back({0.5, 1, 0});
  bent.corners = {0, 1, 2, 3, 0, 8, 4, 5, 6, 7, 4, 8};
  expect_covers_however_it_lies(bent, random);
}

TEST(InputPolygonShapes, HolesWhoseBridgeHasCornersOfItsOwn) {
  Face face = whole(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}});
  const Input input = read_face(face);
  expect_covers(input, face);
  EXPECT_TRUE(has_finding(input, "duplicate_positions"));
}

TEST(InputPolygonShapes, CornersAtOnePlace) {
  for (std::size_t at = 0; at < letter_u.size(); ++at) {
    Corners p = letter_u;
    p.insert(p.begin() + static_cast<std::ptrdiff_t>(at), letter_u[at]);
    expect_covers(read_face(whole(p)), whole(p));
  }
}

TEST(InputPolygonShapes, PathsGoRoundWhatIsLeftOut) {
  const Input input = read_face(whole(letter_u));
  for (const auto& [a, b, c] : input.triangles) {
    const Vec3 middle = (input.positions[a] + input.positions[b] + input.positions[c]) / 3;
    EXPECT_FALSE(middle.x > 1 && middle.x < 2 && middle.y > 1);
  }
}

TEST(InputPolygonShapes, CrossingOnesAreRefused) {
  expect_refused_face(whole({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));  // a bow-tie without area
  expect_refused_face(whole({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}));  // and with some
  expect_refused_face(whole({{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}}));
  // Round its first corner by 470 degrees: every triangle of the fan turns the same way.
  expect_refused_face(whole({{0, 0, 0}, {1, 0, 0}, {-.6, 1.04, 0}, {-.7, -1.2, 0}, {1.6, -.3, 0}, {-.7, 1.9, 0}}));
  Corners touching = letter_u;
  touching[4] = {1, 2, 0};
  expect_refused_face(whole(touching));
}

TEST(InputPolygonShapes, BridgesToNoHoleAreRefused) {
  Face wrong = with_hole;
  wrong.corners = {0, 1, 2, 3, 0, 4, 7, 6, 5, 4};  // the hole turns the other way
  expect_refused_face(wrong);
  wrong = with_hole;
  for (std::size_t i = 4; i < 8; ++i) wrong.positions[i] = -wrong.positions[i];  // outside
  expect_refused_face(wrong);
  wrong = with_hole;
  for (std::size_t i = 4; i < 8; ++i) wrong.positions[i] = wrong.positions[i] + Vec3{2.5, 2.5, 0};  // across the edge
  expect_refused_face(wrong);
  Face outward = whole({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {-1, 5, 0}});
  outward.corners.push_back(3);
  expect_refused_face(outward);
  wrong.corners = {0, 1, 2, 0, 3};  // a corner again, and no bridge
  expect_refused_face(wrong);
}

TEST(InputPolygonShapes, NearlyPlanarOnesAreToldAndOthersRefused) {
  const auto bent = [](double height) {
    Corners p = letter_u;
    for (std::size_t i = 0; i < p.size(); i += 2) p[i].z = height;
    return whole(p);
  };
  EXPECT_FALSE(has_warning(read_face(bent(1e-6))));
  const Input told = read_face(bent(1e-3));
  EXPECT_TRUE(has_finding(told, "nonplanar_polygons"));
  EXPECT_EQ(told.positions, bent(1e-3).positions);
  expect_refused([&] { read_face(bent(0.2)); }, InputFault::unsupported, "not planar");
}

}  // namespace
}  // namespace geodrome::testing
