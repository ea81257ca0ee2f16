// SPDX-License-Identifier: MIT
#include <cmath>
#include <numeric>
#include <random>

#include "tests/plugins/solver_chen_han/rows_fixture.hpp"
#include "tests/support/same_bytes.hpp"
#include "tests/support/stops_after.hpp"
#include "tools/shapes/split_vertices.hpp"

/// Rows by lists of direct paths are what plain searches tell, whatever the mesh, the plan and the request.
namespace geodrome::test {
namespace {

MeshPtr rough() { return shapes::small::bumpy_torus(24, 16, 0.15, 5); }

TEST(Rows, AreThoseOfPlainSearches) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::size_t number = 0;
    for (const MeshPtr& mesh : bending_meshes(seed)) {
      Planned planned(mesh);
      ASSERT_TRUE(planned) << number << ": " << planned.told();
      EXPECT_LE(planned.worst({}, 3), row_rounding) << "mesh " << number << ", seed " << seed;
      ++number;
    }
  }
}

TEST(Rows, AreThoseOfPlainSearchesOnFuzzedMeshes) {
  std::size_t judged = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Planned planned(fuzzed(seed));
    if (!planned) continue;  // no path bends
    EXPECT_LE(planned.worst({}, 9), row_rounding) << "fuzz " << seed;
    ++judged;
  }
  EXPECT_GT(judged, 25U);
}

/// A mesh in which a third of the vertices are moved next to a neighbour: what comes from such a place leaves it, and
/// arrives there, in directions that are all rounding.
MeshPtr with_pairs(const MeshPtr& mesh, double apart, std::uint64_t seed) {
  shapes::Random random(seed);
  std::vector<Vec3> positions(mesh->positions().begin(), mesh->positions().end());
  std::vector<bool> stays(positions.size());
  for (const Triangle& t : mesh->triangles()) {
    if (random.index(3) != 0 || stays[t[0]] || stays[t[1]]) continue;
    stays[t[0]] = stays[t[1]] = true;
    positions[t[0]] = positions[t[1]] + apart * Vec3{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform()};
  }
  return share(SurfaceMesh(positions, {mesh->triangles().begin(), mesh->triangles().end()}));
}

/// Plain searches may be too long by a part of the shortest edges.
TEST(Rows, AreThoseOfPlainSearchesWhereVerticesAreNextToEachOther) {
  for (const double apart : {0.0, 1e-16, 1e-12, 1e-9, 1e-8, 3e-8, 1e-7})
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
      for (const MeshPtr& mesh :
           {shapes::small::terrain(6, 1, seed), share(shapes::lattice_box(3, 3, 3)), grid_with_hole(false)}) {
        Planned planned(with_pairs(mesh, apart, seed));
        if (!planned) continue;  // no path bends
        EXPECT_LE(planned.worst(), row_rounding + apart) << apart << ", seed " << seed;
      }
}

/// Rows of a mesh some of whose vertices are split in two, against the distances before.
void expect_same_after_splits(const MeshPtr& whole, std::size_t count, double gap, std::uint64_t seed) {
  const MeshPtr mesh = share(shapes::split_vertices(*whole, count, gap, seed));
  Planned planned(mesh), before(whole, all_vertices(*whole), infinity, "rows=plain");
  if (!planned) return;  // no path bends
  const std::size_t old = whole->vertex_count(), splits = mesh->vertex_count() - old;
  for (Index v = 0; v < old; v += 7) {
    std::vector<double> row = Planned::distances(planned.row(mesh->at_vertex(v)));
    row.resize(old);
    EXPECT_LE(worst_difference(Planned::distances(before.plain(whole->at_vertex(v))), row),
              row_rounding + 2 * gap * static_cast<double>(splits))
        << gap << ", seed " << seed << ", from " << v;
  }
}

TEST(Rows, AreThoseBeforeVerticesWereSplitInTwo) {
  for (const double gap : {0.0, 1e-16, 1e-15, 6e-15, 1e-12, 1e-9})
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
      expect_same_after_splits(seed % 2 ? shapes::small::plane_grid(6) : shapes::small::terrain(5, 1.5, seed), 3 + seed,
                               gap, seed);
}

/// Windows of a direct run went round a vertex in the place of its source without end here.
TEST(Rows, EndWhereVerticesLieInThePlaceOfTheSource) {
  expect_same_after_splits(shapes::small::terrain(7, 1.5, 100), 33, 1e-16, 100);
  expect_same_after_splits(shapes::small::terrain(6, 1.5, 191), 54, 2e-16, 191);
  expect_same_after_splits(shapes::small::terrain(7, 1.5, 415), 68, 1e-16, 415);
}

/// Faces at random among a few points: edges have many faces, and faces have copies.
TEST(Rows, AreThoseOfPlainSearchesWhereManyFacesMeet) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    shapes::Random random(seed);
    std::vector<Vec3> positions;
    for (int i = 0; i < 14; ++i) positions.push_back({random.uniform(), random.uniform(), random.uniform()});
    std::vector<Triangle> triangles;
    while (triangles.size() < 60) {
      const Triangle t{static_cast<Index>(random.index(14)), static_cast<Index>(random.index(14)),
                       static_cast<Index>(random.index(14))};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }
    Planned planned(share(SurfaceMesh(positions, triangles)));
    ASSERT_TRUE(planned) << planned.told();
    EXPECT_LE(planned.worst(), row_rounding) << "seed " << seed;
  }
}

TEST(Rows, AreSymmetric) {
  for (const MeshPtr& mesh : {rough(), shapes::small::terrain(14, 1, 2)}) {
    Planned planned(mesh);
    const std::size_t n = planned.sources().size();
    std::vector<std::vector<double>> rows;
    double largest = 0;
    for (const SurfacePoint& at : planned.sources()) rows.push_back(Planned::distances(planned.row(at)));
    for (const auto& row : rows) largest = std::max(largest, *std::max_element(row.begin(), row.end()));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) ASSERT_NEAR(rows[i][j], rows[j][i], row_rounding * largest) << i << " " << j;
  }
}

TEST(Rows, DoNotDependOnPlaceSizeAndNumbers) {
  const MeshPtr mesh = rough();
  std::vector<Index> number(mesh->vertex_count());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), std::mt19937_64(3));
  std::vector<Vec3> positions(number.size());
  for (Index v = 0; v < number.size(); ++v) {
    const Vec3 p = mesh->positions()[v];
    positions[number[v]] = 1000 * Vec3{0.8 * p.x - 0.6 * p.y + 3, 0.6 * p.x + 0.8 * p.y - 1, p.z};
  }
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh->triangles()) triangles.push_back({number[t[1]], number[t[2]], number[t[0]]});
  Planned here(mesh), there(share(SurfaceMesh(positions, triangles)));
  for (Index v = 0; v < number.size(); v += 11) {
    std::vector<double> moved = Planned::distances(there.row(there.sources()[number[v]])), back(moved.size());
    for (Index w = 0; w < back.size(); ++w) back[w] = moved[number[w]] / 1000;
    EXPECT_LE(worst_difference(Planned::distances(here.row(here.sources()[v])), back), rounding);
  }
}

/// Of a cut plan and of one that is not.
TEST(Rows, EndAtARadiusAsPlainSearchesDo) {
  for (const MeshPtr& mesh : {rough(), fuzzed(3), fuzzed(8), shapes::small::both(rough(), rough())}) {
    const std::vector<SurfacePoint> all = all_vertices(*mesh);
    for (const double planned_radius : {0.9, double{infinity}}) {
      Planned planned(mesh, all, planned_radius);
      ASSERT_TRUE(planned) << planned.told();
      for (const double radius : {0.9, 0.31, 1e-9, 0.0})
        EXPECT_LE(planned.worst({.radius = radius}, 5), row_rounding) << radius << " of " << planned_radius;
    }
  }
}

TEST(Rows, OfAPlanWithARadiusHoldFewerPaths) {
  const MeshPtr mesh = rough();
  const std::vector<SurfacePoint> all = all_vertices(*mesh);
  EXPECT_LT(Planned(mesh, all, 0.3).surface().bytes(), Planned(mesh, all).surface().bytes());
  EXPECT_LT(Planned(mesh, {all[3]}, 0.5).surface().bytes(), Planned(mesh, all, 0.5).surface().bytes());
}

TEST(Rows, AreRightFromSomeSourcesToo) {
  const MeshPtr mesh = rough();
  std::vector<SurfacePoint> some = all_vertices(*mesh);
  some.resize(some.size() / 7);
  EXPECT_LE(Planned(mesh, some).worst(), row_rounding);
  Planned near(mesh, some, 0.7);
  EXPECT_LE(near.worst({.radius = 0.7}), row_rounding);
}

TEST(Rows, StopAtTheFarthestTarget) {
  const MeshPtr mesh = rough();
  Planned planned(mesh);
  shapes::Random random(4);
  for (int draw = 0; draw < 20; ++draw) {
    const SurfacePoint source = mesh->at_vertex(random_vertex(mesh, random));
    const std::vector<SurfacePoint> targets{mesh->at_vertex(random_vertex(mesh, random)),
                                            mesh->at_vertex(random_vertex(mesh, random))};
    const Request request{.targets = targets, .stop_at_targets = true};
    const std::vector<double> all = Planned::distances(planned.plain(source));
    const ShortestPathMap& map = planned.row(source, request);
    const double farthest = std::max(map.at(targets[0]).value, map.at(targets[1]).value);
    for (Index v = 0; v < all.size(); ++v) {
      if (map.vertices()[v] != infinity || all[v] < farthest * (1 - row_rounding)) {
        ASSERT_NEAR(map.vertices()[v], all[v], row_rounding * all[v]);
        ASSERT_LE(map.vertices()[v], farthest);
      }
    }
  }
}

TEST(Rows, AddStartDistances) {
  Planned planned(rough());
  EXPECT_LE(planned.worst({}, 7, 2.5), row_rounding);
  EXPECT_LE(planned.worst({.radius = 3}, 7, 2.5), row_rounding);
}

TEST(Rows, TellWhatIsUnreachableAndWhatIsBeyondTheLimit) {
  const MeshPtr torus = rough(), mesh = shapes::small::both(torus, torus);
  Planned planned(mesh);
  const ShortestPathMap& map = planned.row(mesh->at_vertex(0), {.radius = 0.5});
  const Index far = 16 * 12, other = static_cast<Index>(torus->vertex_count());
  EXPECT_EQ(map.at(mesh->at_vertex(0)).reach, Reach::reached);
  EXPECT_EQ(map.at(mesh->at_vertex(0)).value, 0);
  EXPECT_EQ(map.at(mesh->at_vertex(far)).reach, Reach::beyond_limit);
  EXPECT_EQ(map.at(mesh->at_vertex(other)).reach, Reach::unreachable);
}

TEST(Rows, HaveTheSameBytesForAnyNumberOfThreads) {
  const MeshPtr mesh = fuzzed(5);
  const std::vector<SurfacePoint> all = all_vertices(*mesh);
  Planned one(mesh, all, infinity, "rows=lists", 1), four(mesh, all, infinity, "rows=lists", 4);
  EXPECT_EQ(one.surface().bytes(), four.surface().bytes());
  for (std::size_t i = 0; i < all.size(); i += 5)
    ASSERT_TRUE(same_bytes(Planned::distances(one.row(all[i])), Planned::distances(four.row(all[i]))));
}

/// Run between rows, so that neither leaves anything to the other.
TEST(Rows, LeaveOtherRequestsToPlainSearches) {
  const MeshPtr mesh = rough();
  std::vector<SurfacePoint> some = all_vertices(*mesh);
  const SurfacePoint outside = some.back(), inside{7, {0.25, 0.25, 0.5}};
  some.pop_back();
  Planned planned(mesh, some, 1.0);
  const std::vector<double> before = Planned::distances(planned.row(some[4], {.radius = 1}));
  const auto expect_plain = [&](const SurfacePoint& at, const Request& request) {
    EXPECT_TRUE(
        same_bytes(Planned::distances(planned.plain(at, request)), Planned::distances(planned.row(at, request))));
    EXPECT_TRUE(same_bytes(Planned::distances(planned.row(some[4], {.radius = 1})), before));
  };
  expect_plain(outside, {.radius = 0.8});
  expect_plain(inside, {.radius = 0.8});
  expect_plain(some[3], {.radius = 1.1});
  expect_plain(some[3], {});
  expect_plain(some[3], {.radius = 0.8, .keep = Keep::map});
  expect_plain(some[3], {.radius = 0.8, .targets = {&inside, 1}});
  EXPECT_EQ(planned.row(some[3], {.radius = 9, .targets = {&inside, 1}}).at(inside).value,
            planned.plain(some[3], {.radius = 9, .targets = {&inside, 1}}).at(inside).value);
  std::vector<SurfacePoint> path;
  planned.row(some[3], {.keep = Keep::map}).path(outside, path);
  EXPECT_GE(path.size(), 2U);
}

TEST(Rows, RefuseWhatPlainSearchesRefuse) {
  const MeshPtr mesh = rough();
  Planned planned(mesh);
  const SurfacePoint off{static_cast<Index>(mesh->face_count()), {1, 0, 0}};
  EXPECT_THROW(planned.row(off), InputError);
  EXPECT_THROW(planned.row(mesh->at_vertex(1), {.targets = {&off, 1}}), InputError);
  EXPECT_THROW(planned.row(mesh->at_vertex(1), {}, -1), InputError);
  std::vector<SurfacePoint> path;
  EXPECT_THROW(planned.row(mesh->at_vertex(1)).path(mesh->at_vertex(2), path), CapabilityError);
}

TEST(Rows, CountWhatTheyDid) {
  const MeshPtr mesh = rough();
  Planned planned(mesh);
  const ShortestPathMap& map = planned.row(mesh->at_vertex(0));
  const auto counter = [&](std::string_view name) {
    for (const Counter& c : map.counters())
      if (name == c.name) return c.value;
    ADD_FAILURE() << "no counter " << name;
    return std::uint64_t{0};
  };
  EXPECT_GT(counter("list_vertices_settled"), 10U);
  EXPECT_GT(counter("list_paths_tried"), counter("list_vertices_settled"));
  EXPECT_GT(counter("largest_search_bytes"), 8 * mesh->vertex_count());
}

TEST(Rows, CanBeCancelledAtAnyTime) {
  const MeshPtr mesh = rough();
  const std::vector<SurfacePoint> all = all_vertices(*mesh);
  const auto solver = load_solver("chen_han:rows=lists");
  QuietContext quiet;
  const auto surface = solver.object->prepare(mesh, quiet);
  const auto* table = solver.extension<ManySearches>();
  for (int polls = 0; polls < 400; polls += 13) {
    StopsAfter context(polls);
    EXPECT_THROW(table->prepare(*surface, {all, infinity}, context), Cancelled) << polls;
  }
  const auto planned = table->prepare(*surface, {all, infinity}, quiet);
  const auto search = planned->make_search();
  const Source source{all[5], 0};
  const std::vector<double> whole = Planned::distances(search->run({&source, 1}, {}, quiet));
  for (int polls = 0; polls < 2; ++polls) {
    StopsAfter context(polls);
    EXPECT_THROW(search->run({&source, 1}, {}, context), Cancelled) << polls;
    EXPECT_TRUE(same_bytes(Planned::distances(search->run({&source, 1}, {}, quiet)), whole));
  }
}

}  // namespace
}  // namespace geodrome::test
