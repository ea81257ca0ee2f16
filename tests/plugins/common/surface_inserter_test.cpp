// SPDX-License-Identifier: MIT
#include "plugins/common/surfaces/surface_inserter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "geodrome/vertex_components.hpp"
#include "plugins/common/surfaces/point_insertion.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A tube of radius 0.35 around the trefoil knot.
MeshPtr trefoil(Index m, Index n) {
  const auto axis = [](double t) {
    return Vec3{std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
  };
  return tube(m, n, true, true, [&](Index i, Index j) {
    const double t = 2 * pi * i / m, v = 2 * pi * j / n;
    Vec3 along = axis(t + 1e-4) - axis(t - 1e-4);
    along = along / norm(along);
    Vec3 across = cross(along, {0, 0, 1});
    across = across / norm(across);
    return axis(t) + 0.35 * (std::cos(v) * across + std::sin(v) * cross(across, along));
  });
}

/// A torus of the same number of vertices, at random places of each cell: angles of all sizes.
MeshPtr ragged_torus(Index m, Index n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return tube(m, n, true, true, [&](Index i, Index j) {
    const double u = 2 * pi * (i + 0.7 * uniform(random)) / m, v = 2 * pi * (j + 0.7 * uniform(random)) / n;
    const double r = 1 + 0.4 * std::cos(v);
    return Vec3{r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)};
  });
}

/// A mesh with all its vertices, and more points that are none, as a sample.
struct Case {
  MeshPtr mesh;
  std::vector<Index> sample_of_vertex;
  PointSample sample;

  Case(MeshPtr surface, const std::vector<Vec3>& more) : mesh(std::move(surface)) {
    for (Index v = 0; v < mesh->vertex_count(); ++v) sample_of_vertex.push_back(v);
    sample.points.assign(mesh->positions().begin(), mesh->positions().end());
    sample.points.insert(sample.points.end(), more.begin(), more.end());
  }
  Index first() const { return static_cast<Index>(mesh->vertex_count()); }
  std::unique_ptr<PointInserter> inserter() const { return make_inserter(mesh, sample_of_vertex, sample); }
};

/// Points at vertices, edges and insides of faces, moved off the surface by up to `off` of the longest edge there.
std::vector<Vec3> points_near(const SurfaceMesh& mesh, std::size_t count, double off, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points;
  while (points.size() < count) {
    const SurfacePoint at = random_point(mesh, random);
    const auto [p, q, r] = mesh.corners(at.face);
    const double edge = std::max({distance(p, q), distance(q, r), distance(r, p)});
    const Vec3 move{2 * uniform(random) - 1, 2 * uniform(random) - 1, 2 * uniform(random) - 1};
    points.push_back(mesh.position(at) + off * edge * uniform(random) * move);
  }
  return points;
}

long euler_number(const SurfaceMesh& mesh) {
  std::size_t half = 0, border = 0;
  for (const Index twin : mesh.twins()) ++(twin == no_index ? border : half);
  std::set<Index> used;
  for (const Triangle& t : mesh.triangles()) used.insert(t.begin(), t.end());
  return static_cast<long>(used.size()) - static_cast<long>(half / 2 + border) + static_cast<long>(mesh.face_count());
}

std::size_t component_count(const SurfaceMesh& mesh) {
  const std::vector<Index> components = vertex_components(mesh);
  return std::set<Index>(components.begin(), components.end()).size();
}

/// All that an insertion promises, whatever the point.
void expect_sound(const SurfaceMesh& old, const Inserted& got, const Vec3& point) {
  const SurfaceMesh& mesh = *got.mesh;
  if (got.how == Insertion::existing) {
    EXPECT_EQ(&mesh, &old);
    return;
  }
  ASSERT_EQ(mesh.vertex_count(), old.vertex_count() + 1);
  EXPECT_EQ(got.vertex, old.vertex_count());
  EXPECT_EQ(mesh.positions()[got.vertex], point);
  EXPECT_TRUE(std::equal(old.positions().begin(), old.positions().end(), mesh.positions().begin()));
  EXPECT_TRUE(mesh.manifold());
  EXPECT_TRUE(mesh.oriented());
  EXPECT_EQ(mesh.closed(), old.closed());
  EXPECT_EQ(euler_number(mesh), euler_number(old));
  EXPECT_EQ(component_count(mesh), component_count(old));
  for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_NE(mesh.first_half_edge(v), no_index) << v;
  // Every face is an old one in its place, or one of the star.
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangles()[f];
    if (std::ranges::find(t, got.vertex) == t.end()) {
      ASSERT_LT(f, old.face_count());
      EXPECT_EQ(t, old.triangles()[f]);
    }
  }
}

std::map<Insertion, std::size_t> insert_all(const Case& example) {
  std::map<Insertion, std::size_t> counts;
  const auto inserter = example.inserter();
  for (Index s = example.first(); s < example.sample.size(); ++s) {
    const Inserted got = inserter->with(s);
    ++counts[got.how];
    expect_sound(*example.mesh, got, example.sample.points[s]);
    if (testing::Test::HasFailure()) break;
  }
  return counts;
}

class SurfaceInserter : public testing::TestWithParam<std::pair<const char*, MeshPtr>> {};

TEST_P(SurfaceInserter, KeepsTheManifoldItsVerticesItsTopologyAndAllFacesOutsideTheStar) {
  const MeshPtr mesh = GetParam().second;
  for (const double off : {0.0, 0.05, 0.4}) {
    SCOPED_TRACE(off);
    const auto counts = insert_all({mesh, points_near(*mesh, 120, off, 7)});
    EXPECT_GT(counts.at(Insertion::cavity), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SurfaceInserter,
                         testing::Values(std::pair{"torus", bumpy_torus(30, 14, 0.02, 3)},
                                         std::pair{"ragged_torus", ragged_torus(30, 14, 4)},
                                         std::pair{"trefoil", trefoil(90, 9)}, std::pair{"plane", plane_grid(12)},
                                         std::pair{"crossed_plane", plane_grid(12, true)},
                                         std::pair{"terrain", terrain(12, 0.6, 5)}, std::pair{"cube", cube()},
                                         std::pair{"prism", prism(7, 5, 0.5)},
                                         std::pair{"two_tori", both(bumpy_torus(12, 8, 0, 1), plane_grid(3))}),
                         [](const auto& info) { return info.param.first; });

TEST(SurfaceInserterOnce, APointThatIsAVertexGivesTheMeshItselfAndThatVertex) {
  const Case example(bumpy_torus(12, 8, 0.02, 1), {});
  const auto inserter = example.inserter();
  for (Index v = 0; v < example.mesh->vertex_count(); ++v) {
    const Inserted got = inserter->with(v);
    EXPECT_EQ(got.mesh, example.mesh);
    EXPECT_EQ(got.vertex, v);
    EXPECT_EQ(got.how, Insertion::existing);
  }
}

TEST(SurfaceInserterOnce, APointAtAVertexWithinRoundingIsThatVertex) {
  const MeshPtr mesh = plane_grid(4);
  const Case example(mesh, {{2, 2 + 1e-12, 0}, {2, 2 + 1e-6, 0}});
  const auto inserter = example.inserter();
  EXPECT_EQ(inserter->with(example.first()).vertex, 2 * 5 + 2u);
  EXPECT_EQ(inserter->with(example.first()).mesh, mesh);
  EXPECT_EQ(inserter->with(example.first() + 1).vertex, mesh->vertex_count());
}

TEST(SurfaceInserterOnce, RefusesAPointThatIsNotThere) {
  const Case example(plane_grid(2), {{std::nan(""), 0, 0}});
  EXPECT_THROW(example.inserter()->with(example.first()), SampleError);
  EXPECT_THROW(example.inserter()->with(example.first() + 1), SampleError);
}

double smallest_angle(const SurfaceMesh& mesh) {
  double smallest = pi;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.corners(f);
    for (int i = 0; i < 3; ++i) {
      const Vec3 u = c[(i + 1) % 3] - c[i], v = c[(i + 2) % 3] - c[i];
      smallest = std::min(smallest, std::atan2(norm(cross(u, v)), dot(u, v)));
    }
  }
  return smallest;
}

double area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    sum += norm(cross(q - p, r - p)) / 2;
  }
  return sum;
}

/// In the plane the sphere's section is the circumcircle: what comes out is the Delaunay triangulation of all points.
TEST(SurfaceInserterOnce, InAPlaneTheStarIsTheDelaunayStar) {
  const MeshPtr mesh = plane_grid(6, true);
  const Case example(mesh, points_near(*mesh, 200, 0, 11));
  const auto inserter = example.inserter();
  for (Index s = example.first(); s < example.sample.size(); ++s) {
    const Inserted got = inserter->with(s);
    if (got.how == Insertion::existing) continue;
    EXPECT_EQ(got.how, Insertion::cavity);
    EXPECT_NEAR(area(*got.mesh), 36, 1e-9);
    for (Index f = 0; f < got.mesh->face_count(); ++f) {
      if (std::ranges::find(got.mesh->triangles()[f], got.vertex) == got.mesh->triangles()[f].end()) continue;
      const auto [p, q, r] = got.mesh->corners(f);
      const Vec3 u = q - p, v = r - p, n = cross(u, v);
      ASSERT_GT(norm(n), 0);
      const Vec3 centre = cross(squared_norm(u) * v - squared_norm(v) * u, n) / (2 * squared_norm(n));
      for (const Vec3& other : mesh->positions())
        EXPECT_GT(distance(other, p + centre), norm(centre) * (1 - 1e-6)) << s << " " << f;
    }
  }
}

TEST(SurfaceInserterOnce, BeyondABoundaryTheSurfaceGrows) {
  const MeshPtr mesh = plane_grid(4);
  const Case example(mesh, {{2.5, 4.2, 0}, {2.5, 4, 0}, {2.5, 3.9, 0}, {4.1, 4.1, 0}, {-0.3, 1, 0}, {2.5, 6, 0}});
  const auto inserter = example.inserter();
  const auto got = [&](Index i) {
    const Inserted result = inserter->with(example.first() + i);
    expect_sound(*mesh, result, example.sample.points[example.first() + i]);
    return result;
  };
  EXPECT_EQ(got(0).how, Insertion::extended);
  EXPECT_NEAR(area(*got(0).mesh), 16 + 0.1, 1e-12);
  EXPECT_EQ(got(1).how, Insertion::cavity) << "on the edge";
  EXPECT_NEAR(area(*got(1).mesh), 16, 1e-12);
  EXPECT_EQ(got(2).how, Insertion::cavity) << "inside";
  EXPECT_NEAR(area(*got(2).mesh), 16, 1e-12);
  EXPECT_EQ(got(3).how, Insertion::extended) << "beyond a corner";
  EXPECT_GT(area(*got(3).mesh), 16);
  EXPECT_EQ(got(4).how, Insertion::extended) << "beyond a vertex of a straight boundary";
  EXPECT_EQ(got(5).how, Insertion::extended) << "far out, so that no sphere holds it";
  EXPECT_EQ(got(5).mesh->face_count(), mesh->face_count() + 1);
}

TEST(SurfaceInserterOnce, AnglesStaySaneOnASmoothSurface) {
  // Points inside faces of a fine torus, at least a tenth of the face away from edges and corners.
  const MeshPtr mesh = bumpy_torus(60, 26, 0, 1);
  std::mt19937_64 random(5);
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i) {
    const double a = 0.1 + 0.4 * uniform(random), b = 0.1 + 0.4 * uniform(random);
    points.push_back(mesh->position({static_cast<Index>(random() % mesh->face_count()), {a, b, 1 - a - b}}));
  }
  const Case example(mesh, points);
  const auto inserter = example.inserter();
  for (Index s = example.first(); s < example.sample.size(); ++s) {
    const Inserted got = inserter->with(s);
    EXPECT_EQ(got.how, Insertion::cavity);
    EXPECT_GT(smallest_angle(*got.mesh), 0.1) << s;
  }
}

TEST(SurfaceInserterOnce, ASharpEdgeIsNotCutOff) {
  // A point of a cube's face, within the sphere of the face around the edge, yet must not be used.
  const Case example(cube(), {{0.5, 0.4, 0}});
  const Inserted got = example.inserter()->with(example.first());
  expect_sound(*example.mesh, got, example.sample.points.back());
  EXPECT_EQ(got.how, Insertion::partial);
  EXPECT_NEAR(area(*got.mesh), 6, 1e-12);
}

TEST(SurfaceInserterOnce, TheSphereLeavesOutTheOtherSheet) {
  // Two squares, back to back, joined along one edge by a hairpin: the sheet below is nearer than the faces are large.
  const MeshPtr mesh =
      make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, -0.2}, {1, 0, -0.2}, {1, 1, -0.2}, {0, 1, -0.2}},
           {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {0, 4, 1}, {1, 4, 5}});
  const Case example(mesh, {{0.5, 0.4, 0.01}});
  const Inserted got = example.inserter()->with(example.first());
  expect_sound(*mesh, got, example.sample.points.back());
  for (const Index f : {2u, 3u, 4u, 5u}) EXPECT_EQ(got.mesh->triangles()[f], mesh->triangles()[f]);
}

}  // namespace
}  // namespace geodrome::test
