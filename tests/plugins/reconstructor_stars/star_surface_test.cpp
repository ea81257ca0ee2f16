// SPDX-License-Identifier: MIT
#include "plugins/reconstructor_stars/star_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>

#include "tests/support/meshes.hpp"
#include "tests/support/sample_stages.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/threads_context.hpp"
#include "tests/support/topology.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

using shapes::Sampling;
using test::faces_of, test::Topology, test::topology;

Reconstruction reconstruct(const test::Staged& s, const char* options = "", unsigned threads = 2) {
  test::ThreadsContext context(threads);
  return StarSurface(OptionValues(StarSurface::options, options))
      .reconstruct(s.sample, s.tangents, s.control, s.kept, context);
}

/// The refusal of a sample; nothing if a surface came out.
std::optional<SampleError> refusal_of(const test::Staged& s, const char* options = "") {
  try {
    reconstruct(s, options);
    return std::nullopt;
  } catch (const SampleError& error) {
    return error;
  }
}

const Finding* find(const SampleError& error, const std::string& code) {
  const auto& all = error.findings();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Finding& f) { return f.code == code; });
  return found == all.end() ? nullptr : &*found;
}

test::Staged staged(const char* shape, std::size_t points, Sampling sampling, std::uint64_t seed) {
  return test::staged(shapes::sample(shape, {.points = points, .sampling = sampling, .seed = seed}));
}

/// Where all points lie on a sphere, all edges of their Voronoi cells run through its centre, and any plane across a
/// cell has the same corners: no wrong normal matters.
TEST(StarSurface, MakesSpheresWhateverTheNormals) {
  test::Staged s = test::staged(test::sphere(1000, 3), false);
  const Reconstruction right = reconstruct(s);
  test::Random random(7);
  for (TangentPlane& plane : s.tangents.plane) {
    const Vec3 normal = plane.normal + 0.5 * random.direction();
    plane.normal = normal / norm(normal);
  }
  EXPECT_EQ(faces_of(reconstruct(s)), faces_of(right));
}

TEST(StarSurface, MakesSpheresOfRandomPoints) {
  for (const Sampling sampling : {Sampling::uniform, Sampling::blue})
    for (const std::size_t points : {300, 1000, 4000})
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const test::Staged s = staged("sphere", points, sampling, seed);
        const Reconstruction made = reconstruct(s);
        EXPECT_EQ(topology(*made.mesh), (Topology{2, 0, 1})) << points << " points, seed " << seed;
        EXPECT_EQ(made.mesh->vertex_count(), s.kept.size());
        EXPECT_GT(test::volume(*made.mesh), 0) << "faces must look outwards";
        EXPECT_TRUE(made.findings.empty());
      }
}

TEST(StarSurface, MakesDiscsOfRandomPlanesAndOfSpheresWithAHole) {
  for (const char* shape : {"plane", "cut-sphere"})
    for (const Sampling sampling : {Sampling::uniform, Sampling::blue}) {
      const Reconstruction made = reconstruct(staged(shape, 3000, sampling, 2));
      const Topology t = topology(*made.mesh);
      EXPECT_EQ(t, (Topology{1, t.boundary_edges, 1})) << shape;
      EXPECT_GT(t.boundary_edges, 20u) << shape;
      ASSERT_EQ(std::count_if(made.findings.begin(), made.findings.end(),
                              [](const Finding& f) { return f.code == "boundary"; }),
                1)
          << shape;
    }
}

TEST(StarSurface, KeepsSpheresInsideEachOtherApart) {
  PointSample both = test::sphere(3000, 2);
  for (const Vec3& p : test::sphere(1500, 1).points) both.points.push_back(0.5 * p);
  const Reconstruction made = reconstruct(test::staged(both));
  EXPECT_EQ(topology(*made.mesh), (Topology{4, 0, 2}));
  EXPECT_NEAR(test::volume(*made.mesh), 4.0 / 3 * std::numbers::pi * 1.125, 0.1) << "both look outwards";
}

struct Shape {
  const char* name;
  long euler;
};

TEST(StarSurface, IsRightOrRefusedWithPlacesButNeverWrong) {
  constexpr Shape shapes[] = {{"sphere", 2}, {"ellipsoid", 2}, {"torus", 0}, {"genus2", -2}, {"trefoil", 0}};
  int right = 0, refused = 0;
  for (const auto& [name, euler] : shapes)
    for (const Sampling sampling : {Sampling::uniform, Sampling::blue, Sampling::grid})
      for (const auto& [points, seed] : {std::pair(600, 1), std::pair(2500, 2), std::pair(2500, 3)}) {
        const test::Staged s = staged(name, points, sampling, seed);
        if (const auto refusal = refusal_of(s)) {
          ++refused;
          const Finding& first = refusal->findings().at(0);
          EXPECT_EQ(first.severity, Finding::Severity::refusal) << name;
          EXPECT_FALSE(first.elements.empty()) << name;
          for (const Index p : first.elements)
            EXPECT_TRUE(std::binary_search(s.kept.begin(), s.kept.end(), p)) << name << ", point " << p;
          continue;
        }
        ++right;
        EXPECT_EQ(topology(*reconstruct(s).mesh), (Topology{euler, 0, 1})) << name << ' ' << points << ' ' << seed;
      }
  EXPECT_EQ(right + refused, 45);
  EXPECT_GE(right, 6) << "spheres of random points";
  EXPECT_GE(refused, 24) << "lattices, and shapes with handles";
}

TEST(StarSurface, RefusesLatticesWhereTheirCellsAreCocircular) {
  for (const PointSample& lattice : {test::plane_lattice(20, 20), test::moved(test::plane_lattice(20, 20), 1, {})}) {
    const auto refusal = refusal_of(test::staged(lattice, false));
    ASSERT_TRUE(refusal);
    const Finding* edges = find(*refusal, "crowded_edges");
    ASSERT_TRUE(edges);
    EXPECT_GT(edges->count, 50u);
    EXPECT_TRUE(find(*refusal, "disputed_triangles"));
    EXPECT_NE(refusal->message().find("the worst at point " + std::to_string(edges->elements.at(0))),
              std::string::npos);
    EXPECT_FALSE(refusal->remedy().empty());
  }
}

/// A sphere, which comes out right, with a rough patch: everything named must be there.
TEST(StarSurface, NamesThePlacesThatAreWrong) {
  const Vec3 centre{0, 0, 1};
  test::Staged s = test::staged(test::sphere(2000, 4), false);
  ASSERT_FALSE(refusal_of(s));
  test::Random random(5);
  for (Vec3& p : s.sample.points)
    if (distance(p, centre) < 0.25) p = random.uniform(0.95, 1.05) * p;
  const auto refusal = refusal_of(s);
  ASSERT_TRUE(refusal);
  for (const char* code : {"crowded_edges", "disputed_triangles"}) {
    const Finding* finding = find(*refusal, code);
    ASSERT_TRUE(finding) << code;
    EXPECT_FALSE(finding->elements.empty());
    for (const Index p : finding->elements) EXPECT_LT(distance(s.sample.points[p], centre), 0.4) << code;
  }
}

TEST(StarSurface, HeedsTheBoundaryRule) {
  const test::Staged s = staged("cut-sphere", 3000, Sampling::uniform, 3);
  EXPECT_FALSE(refusal_of(s, "boundary=open"));
  const auto refusal = refusal_of(s, "boundary=closed");
  ASSERT_TRUE(refusal);
  const Finding* boundary = find(*refusal, "boundary");
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->count, 1u);
  EXPECT_FALSE(refusal_of(staged("sphere", 1000, Sampling::uniform, 3), "boundary=closed"));
}

TEST(StarSurface, RefusesAHoleOfAFewPointsAsAThinPlace) {
  const Vec3 centre{0, 0, 1};
  PointSample sample;
  for (const Vec3& p : shapes::sample("sphere", {.points = 1000, .sampling = Sampling::blue, .seed = 5}).points)
    if (distance(p, centre) > 0.22) sample.points.push_back(p);
  test::Staged s = test::staged(sample, false);
  s.control.psi.assign(s.sample.size(), 0.07);  // smaller than the hole, which the control function itself would see
  const auto refusal = refusal_of(s);
  ASSERT_TRUE(refusal);
  const Finding* thin = find(*refusal, "thin_places");
  ASSERT_TRUE(thin) << refusal->what();
  EXPECT_EQ(thin->count, 1u);
  for (const Index p : thin->elements) EXPECT_LT(distance(s.sample.points[p], centre), 0.4);
  EXPECT_FALSE(refusal_of(s, "boundary=open"));
}

TEST(StarSurface, InsertsPoints) {
  const test::Staged s = staged("sphere", 1000, Sampling::uniform, 4);
  const Reconstruction made = reconstruct(s);
  ASSERT_TRUE(made.inserter);
  Index left_out = 0;
  while (std::binary_search(s.kept.begin(), s.kept.end(), left_out)) ++left_out;
  const Inserted inserted = made.inserter->with(left_out);
  ASSERT_NE(inserted.how, Insertion::existing);
  EXPECT_EQ(inserted.mesh->positions()[inserted.vertex], s.sample.points[left_out]);
  EXPECT_EQ(inserted.mesh->vertex_count(), made.mesh->vertex_count() + 1);
  EXPECT_EQ(topology(*inserted.mesh), (Topology{2, 0, 1}));
}

TEST(StarSurface, DoesNotDependOnTheOrderOfPoints) {
  const PointSample sample = test::sphere(1500, 5);
  const std::vector<Index> order = test::permutation(sample.size(), 6);
  const Reconstruction a = reconstruct(test::staged(sample, false)),
                       b = reconstruct(test::staged(test::permuted(sample, order), false));
  EXPECT_EQ(faces_of(a), faces_of(b, order));
}

TEST(StarSurface, DoesNotDependOnPlaceAndScale) {
  const PointSample sample = test::sphere(1500, 8);
  const auto faces = faces_of(reconstruct(test::staged(sample, false)));
  for (const double scale : {1e-6, 1.0, 1e6})
    EXPECT_EQ(faces, faces_of(reconstruct(test::staged(test::moved(sample, scale, {3 * scale, -scale, scale}), false))))
        << "scale " << scale;
}

TEST(StarSurface, GivesTheSameBytesForAnyNumberOfThreads) {
  const test::Staged s = staged("sphere", 3000, Sampling::uniform, 2);
  const Reconstruction one = reconstruct(s, "", 1), three = reconstruct(s, "", 3);
  EXPECT_TRUE(std::ranges::equal(one.mesh->triangles(), three.mesh->triangles()));
  EXPECT_EQ(one.sample_of_vertex, three.sample_of_vertex);
}

}  // namespace
}  // namespace geodrome
