// SPDX-License-Identifier: MIT
#include <limits>
#include <numbers>

#include "tests/plugins/solvers/fixture.hpp"

namespace geodrome::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A grid of `columns` x `rows` quads, closed in the first direction; vertex (i, j) is number j columns + i.
template <class Place>
MeshPtr ring_grid(Index columns, Index rows, shapes::Random& random, Place place) {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i < columns; ++i) positions.push_back(place(i, j));
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * columns + i, b = j * columns + (i + 1) % columns, c = b + columns, d = a + columns;
      const bool first = random.uniform() < 0.5;
      triangles.push_back(first ? Triangle{a, b, c} : Triangle{a, b, d});
      triangles.push_back(first ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  return share(SurfaceMesh(positions, triangles));
}

/// Layers at random heights, ascending from 0.
std::vector<double> random_layers(Index rows, double low, double high, shapes::Random& random) {
  std::vector<double> at(1, low);
  for (Index j = 1; j <= rows; ++j) at.push_back(at.back() + (high - low) / rows * random.uniform(0.2, 1.8));
  return at;
}

TEST_P(ExactSolver, UnrollsThePrism) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    shapes::Random random(seed);
    const Index sides = 3 + static_cast<Index>(random.index(20)), rows = 2 + static_cast<Index>(random.index(6));
    const std::vector<double> height = random_layers(rows, 0, random.uniform(0.5, 5), random);
    const MeshPtr mesh = ring_grid(sides, rows, random, [&](Index i, Index j) {
      return Vec3{std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), height[j]};
    });
    const Index source = random_vertex(mesh, random);
    const std::vector<double> d = from_vertex(solver_, mesh, source);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const Index apart = (v % sides + sides - source % sides) % sides;
      const double around = std::min(apart, sides - apart) * 2 * std::sin(pi / sides);
      const double truth = std::hypot(around, height[v / sides] - height[source / sides]);
      ASSERT_NEAR(d[v], truth, rounding * (1 + truth)) << "seed " << seed << " vertex " << v;
    }
  }
}

/// The side of a pyramid, unrolled from the tip: less than a full turn, so that no way between two points passes the
/// tip.
TEST_P(ExactSolver, UnrollsTheConeWithItsTip) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    shapes::Random random(seed);
    const Index sides = 3 + static_cast<Index>(random.index(20)), rows = 1 + static_cast<Index>(random.index(6));
    const double height = random.uniform(0.2, 4), slant = std::hypot(1, height);
    const std::vector<double> part = random_layers(rows, 0.3, 2, random);
    const MeshPtr open = ring_grid(sides, rows, random, [&](Index i, Index j) {
      return part[j] * Vec3{std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), -height};
    });
    std::vector<Vec3> positions(open->positions().begin(), open->positions().end());
    std::vector<Triangle> triangles(open->triangles().begin(), open->triangles().end());
    const auto tip = static_cast<Index>(positions.size());
    positions.push_back({0, 0, 0});
    for (Index i = 0; i < sides; ++i) triangles.push_back({tip, (i + 1) % sides, i});
    const MeshPtr mesh = share(SurfaceMesh(positions, triangles));

    const double angle_of_side = 2 * std::asin(std::sin(pi / sides) / slant);
    const Index source = static_cast<Index>(random.index(tip));
    const std::vector<double> d = from_vertex(solver_, mesh, source);
    EXPECT_NEAR(d[tip], part[source / sides] * slant, rounding * slant);
    for (Index v = 0; v < tip; ++v) {
      const Index apart = (v % sides + sides - source % sides) % sides;
      const double angle = std::min(apart, sides - apart) * angle_of_side;
      const double a = part[source / sides] * slant, b = part[v / sides] * slant;
      const double truth = std::sqrt((a - b) * (a - b) + 4 * a * b * std::pow(std::sin(angle / 2), 2));
      ASSERT_NEAR(d[v], truth, rounding * (1 + truth)) << "seed " << seed << " vertex " << v;
    }
  }
}

/// The six sides of a box, each cut into n x n rectangles; vertices welded by their place on the lattice.
MeshPtr box(const Vec3& size, Index n) {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Index> vertex_at((n + 1) * (n + 1) * (n + 1), no_index);
  const auto vertex = [&](std::array<Index, 3> at) {
    Index& v = vertex_at[(at[2] * (n + 1) + at[1]) * (n + 1) + at[0]];
    if (v == no_index) {
      v = static_cast<Index>(positions.size());
      const double cells = n;  // at / cells is 1 at the far side, so that the corners are exactly those of the box
      positions.push_back({size.x * (at[0] / cells), size.y * (at[1] / cells), size.z * (at[2] / cells)});
    }
    return v;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const Index side : {Index{0}, n})
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
          const auto at = [&](Index u, Index v) {
            std::array<Index, 3> place{};
            place[axis] = side, place[(axis + 1) % 3] = u, place[(axis + 2) % 3] = v;
            return vertex(place);
          };
          const Index a = at(i, j), c = at(i + 1, j + 1);
          const Index b = side ? at(i + 1, j) : at(i, j + 1), d = side ? at(i, j + 1) : at(i + 1, j);
          triangles.push_back({a, b, c});
          triangles.push_back({a, c, d});
        }
  return share(SurfaceMesh(positions, triangles));
}

TEST_P(ExactSolver, FindsTheWayBetweenOppositeCornersOfABox) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    shapes::Random random(seed);
    const Vec3 size{random.uniform(0.2, 3), random.uniform(0.2, 3), random.uniform(0.2, 3)};
    const MeshPtr mesh = box(size, 1 + static_cast<Index>(random.index(5)));
    ASSERT_TRUE(mesh->closed() && mesh->oriented());
    const auto corner = [&](const Vec3& p) {
      const auto found = std::find(mesh->positions().begin(), mesh->positions().end(), p);
      return static_cast<Index>(found - mesh->positions().begin());
    };
    const auto& [a, b, c] = size;
    const double truth = std::min({std::hypot(a + b, c), std::hypot(b + c, a), std::hypot(c + a, b)});
    EXPECT_NEAR(from_vertex(solver_, mesh, corner({0, 0, 0}))[corner(size)], truth, rounding * truth) << seed;
  }
}

TEST_P(ExactSolver, GoesStraightOnARoughlyCutPlane) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    shapes::Random random(seed);
    const MeshPtr mesh = moved(shape("plane", 400), [&](const Vec3& p) {
      const bool inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
      // A third of the grid's spacing of 1/14 turns no triangle over.
      return inside ? p + Vec3{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), 0} : p;
    });
    const Index source = random_vertex(mesh, random);
    const std::vector<double> d = from_vertex(solver_, mesh, source);
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      ASSERT_NEAR(d[v], distance(mesh->positions()[source], mesh->positions()[v]), rounding) << v;
  }
}

/// A convex polyhedron with its vertices on the unit sphere. The nearest-point map onto it is a contraction, so it has
/// no longer ways than the sphere; the central map to the sphere stretches by at most 1 / (distance of its faces from
/// the centre), so its ways are not much shorter either.
TEST_P(ExactSolver, StaysBetweenTheGreatCirclesAndTheirInscribedOnes) {
  for (const std::size_t faces : {20, 80, 320, 1280, 5120}) {
    const MeshPtr mesh = shape("icosphere", faces);
    double inner = 1;
    for (Index f = 0; f < mesh->face_count(); ++f) {
      const auto [p, q, r] = mesh->corners(f);
      const Vec3 normal = cross(q - p, r - p);
      inner = std::min(inner, dot(normal, p) / norm(normal));
    }
    const Index source = 5;
    const std::vector<double> d = from_vertex(solver_, mesh, source);
    const Vec3 s = mesh->positions()[source];
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const Vec3 p = mesh->positions()[v];
      const double great_circle = std::atan2(norm(cross(s, p)), dot(s, p));
      ASSERT_LE(d[v], great_circle + rounding) << faces << " faces, vertex " << v;
      ASSERT_GE(d[v], inner * great_circle - rounding) << faces << " faces, vertex " << v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plugins, ExactSolver, testing::ValuesIn(exact_solvers()), solver_name);

}  // namespace
}  // namespace geodrome::test
