// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/direct_way.hpp"

#include <algorithm>

#include "plugins/solver_aleksandrov/discretization.hpp"
#include "tests/plugins/solver_aleksandrov/intrinsic_fixture.hpp"

namespace geodrome::aleksandrov::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A mesh ready for questions, in units of the flat surface.
struct Ready {
  explicit Ready(const MeshPtr& mesh)
      : surface(mesh), discretization(surface, {.delta = 1, .triangulation = Triangulation::as_is}, QuietContext()) {}
  const SteinerGraph& graph() const { return discretization.graph(); }
  SurfacePoint located(const SurfacePoint& p) const { return discretization.located(surface.inner(p)); }
  double unit() const { return std::ldexp(1, surface.exponent()); }

  PackedMesh surface;
  Discretization discretization;
};

/// A place of a face whose corner 0 is the tip: a distance from the tip, and the angle from the first leg. The legs are
/// 1 long and `wide` apart.
SurfacePoint polar(Index face, double distance, double angle, double wide, bool turned = false) {
  double b1 = distance * std::sin(wide - angle) / std::sin(wide), b2 = distance * std::sin(angle) / std::sin(wide);
  if (angle == 0) b2 = 0;
  if (angle == wide) b1 = 0;
  if (turned) std::swap(b1, b2);
  return {face, {1 - b1 - b2, b1, b2}};
}

double chord(double r, double s, double angle) {
  if (angle >= pi) return std::numeric_limits<double>::infinity();
  return std::hypot(r - s, 2 * std::sqrt(r * s) * std::sin(angle / 2));
}

/// A distance below that of the opposite side: near the tip as a rule, so that the place stays where the angle says.
double any_distance(double wide, Random& random) {
  return std::cos(wide / 2) * std::pow(10, random.index(2) ? 0 : -random.uniform(0, 6)) * random.uniform(0.1, 1);
}
double any_angle(double wide, Random& random) {
  const auto kind = random.index(4);
  return kind == 0 ? 0 : kind == 1 ? wide : random.uniform(0, wide);
}

Point2 on(const SteinerGraph& graph, Index h, double x, Index frame) {
  const double share = x / graph.corner(h).length;
  Barycentric b{};
  b[h % 3] = 1 - share, b[(h + 1) % 3] = share;
  return graph.in_frame(frame, b);
}

/// The way along its crossings.
double measured(const SteinerGraph& graph, const SurfacePoint& from, const DirectWay& way, const SurfacePoint& to) {
  Index face = from.face;
  Point2 at = graph.in_frame(3 * face, from.b);
  double sum = 0;
  for (const auto& [h, g, x] : way.crossings) {
    EXPECT_EQ(h / 3, face);
    sum += length(on(graph, h, x, 3 * face) - at);
    const bool same = graph.corner(g).forward == graph.corner(h).forward;
    face = g / 3, at = on(graph, g, same ? x : graph.corner(g).length - x, 3 * face);
  }
  EXPECT_EQ(face, to.face);
  return sum + length(graph.in_frame(3 * face, to.b) - at);
}

/// That the way is as long as expected, or that there is none; also back.
void expect_way(const Ready& ready, const SurfacePoint& from, const SurfacePoint& to, double expected) {
  for (const auto& [p, q] : {std::pair(from, to), std::pair(to, from)}) {
    const DirectWay way = direct_way(ready.graph(), p, q);
    if (!std::isfinite(expected)) {
      ASSERT_FALSE(std::isfinite(way.distance));
      continue;
    }
    ASSERT_NEAR(way.distance, expected * ready.unit(), 1e-14 * ready.unit());
    ASSERT_NEAR(measured(ready.graph(), p, way, q), way.distance, 1e-14 * ready.unit());
  }
}

/// The shorter of both ways around the tip of a closed fan.
void expect_fan(Index faces, double wide, std::uint64_t seed) {
  Random random(seed);
  const Ready ready(geodrome::test::fan(faces, wide));
  for (int n = 0; n < 400; ++n) {
    const Index i = static_cast<Index>(random.index(faces)), j = static_cast<Index>(random.index(faces));
    const double a = any_angle(wide, random), b = any_angle(wide, random);
    const double r = any_distance(wide, random), s = any_distance(wide, random);
    const double turn = std::abs((static_cast<double>(j) * wide + b) - (static_cast<double>(i) * wide + a));
    const double least = std::min(turn, faces * wide - turn);
    if (std::abs(least - pi) < 1e-6) continue;
    SCOPED_TRACE(testing::Message() << faces << " faces, from " << i << " " << r << " " << a << " to " << j << " " << s
                                    << " " << b);
    expect_way(ready, ready.located(polar(i, r, a, wide)), ready.located(polar(j, s, b, wide)), chord(r, s, least));
  }
}

TEST(DirectWay, GoesTheShorterWayAroundTheTipOfACone) {
  expect_fan(3, 0.5, 1);
  expect_fan(4, 1.2, 2);
  expect_fan(5, 1, 3);
  expect_fan(20, 0.3, 4);
}

TEST(DirectWay, IsNotAroundASaddleByMoreThanHalfATurn) {
  expect_fan(8, 0.9, 5);
  expect_fan(10, 1, 6);
}

/// Strips of triangles around a common vertex, which all begin at one edge; faces run either way. A place is a strip,
/// and an angle from that edge.
struct Strips {
  static constexpr double wide = 0.6;
  static constexpr Index faces = 4;

  explicit Strips(Index count, Random& random) {
    std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}};
    std::vector<Triangle> t;
    for (Index strip = 0; strip < count; ++strip) {
      Index last = 1;
      for (Index i = 0; i < faces; ++i) {
        const auto next = static_cast<Index>(p.size());
        turned.push_back(random.index(2) == 1);
        t.push_back(turned.back() ? Triangle{0, next, last} : Triangle{0, last, next});
        p.push_back(at_angle(p[last], random));
        last = next;
      }
    }
    mesh = geodrome::test::make(p, t);
  }

  /// A unit vector `wide` from another one.
  static Vec3 at_angle(const Vec3& from, Random& random) {
    const Vec3 any{random.normal(), random.normal(), random.normal()}, side = cross(from, any);
    return std::cos(wide) * from + (std::sin(wide) / norm(side)) * side;
  }
  SurfacePoint place(Index strip, Index face, double distance, double angle) const {
    const Index f = strip * faces + face;
    return polar(f, distance, angle, wide, turned[f]);
  }

  MeshPtr mesh;
  std::vector<bool> turned;
};

TEST(DirectWay, CrossesMirroredEdgesAndEdgesOfThreeFaces) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const Index count = 2 + static_cast<Index>(random.index(3));
    const Strips strips(count, random);
    const Ready ready(strips.mesh);
    for (int n = 0; n < 100; ++n) {
      const Index one = static_cast<Index>(random.index(count)), other = static_cast<Index>(random.index(count));
      const Index i = static_cast<Index>(random.index(Strips::faces)),
                  j = static_cast<Index>(random.index(Strips::faces));
      const double a = any_angle(Strips::wide, random), b = any_angle(Strips::wide, random);
      const double r = any_distance(Strips::wide, random), s = any_distance(Strips::wide, random);
      const double first = i * Strips::wide + a, second = j * Strips::wide + b;
      const double turn = one == other ? std::abs(first - second) : first + second;
      if (std::abs(turn - pi) < 1e-6) continue;
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", from " << one << " " << i << " " << r << " " << a
                                      << " to " << other << " " << j << " " << s << " " << b);
      expect_way(ready, ready.located(strips.place(one, i, r, a)), ready.located(strips.place(other, j, s, b)),
                 chord(r, s, turn));
    }
  }
}

/// Ways around a vertex where at each of many edges there are two faces to go on through: 2^40 of them.
TEST(DirectWay, TakesTheLeastTurnWhereManyFacesMeet) {
  constexpr Index count = 40;
  const double wide = 2.5 / count;
  std::vector<Vec3> p{{0, 0, 0}};
  std::vector<Triangle> t;
  const auto leg = [&](double angle, double z) {
    const double r = std::sqrt(1 - z * z);
    p.push_back({r * std::cos(angle), r * std::sin(angle), z});
    return static_cast<Index>(p.size() - 1);
  };
  Index last = leg(0, 0);
  for (Index i = 0; i < count; ++i) {
    const Index roof = leg((i + 0.5) * wide, 0.02), next = leg((i + 1) * wide, 0);
    t.push_back({0, last, next}), t.push_back({0, last, roof}), t.push_back({0, roof, next});
    last = next;
  }
  const Ready ready(geodrome::test::make(p, t));
  const SurfacePoint from = polar(0, 0.1, 0.2 * wide, wide), to = polar(3 * (count - 1), 0.2, 0.7 * wide, wide);
  expect_way(ready, ready.located(from), ready.located(to), chord(0.1, 0.2, (count - 0.5) * wide));
}

TEST(DirectWay, IsNotBetweenFacesThatHaveNoVertexInCommon) {
  const Ready ready(geodrome::test::plane_grid(3));
  const SurfacePoint from = ready.located({0, {0.3, 0.3, 0.4}}), to = ready.located({17, {0.3, 0.3, 0.4}});
  EXPECT_FALSE(std::isfinite(direct_way(ready.graph(), from, to).distance));
}

}  // namespace
}  // namespace geodrome::aleksandrov::test
