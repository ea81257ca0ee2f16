// SPDX-License-Identifier: MIT
#include "plugins/reconstructor_delaunay_cut/delaunay_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/meshes.hpp"
#include "tests/support/sample_stages.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/threads_context.hpp"
#include "tests/support/topology.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

Reconstruction reconstruct(const test::Staged& s, const char* options = "", unsigned threads = 2) {
  test::ThreadsContext context(threads);
  return DelaunayCut(OptionValues(DelaunayCut::options, options))
      .reconstruct(s.sample, s.tangents, s.control, s.kept, context);
}

using test::faces_of, test::Topology, test::topology;

PointSample joined(PointSample a, const PointSample& b) {
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  return a;
}

struct Case {
  const char* shape;
  shapes::Sampling sampling;
  double jitter;
  long euler;
};

class DelaunayCutShapes : public testing::TestWithParam<Case> {};

TEST_P(DelaunayCutShapes, HaveTheRightTopology) {
  const Case c = GetParam();
  PointSample sample = shapes::sample(c.shape, {.points = 5000, .sampling = c.sampling, .seed = 7});
  test::Random random(11);
  for (Vec3& p : sample.points)
    p = p + Vec3{random.uniform(-c.jitter, c.jitter), random.uniform(-c.jitter, c.jitter),
                 random.uniform(-c.jitter, c.jitter)};
  const Reconstruction made = reconstruct(test::staged(std::move(sample)));
  EXPECT_EQ(topology(*made.mesh), (Topology{c.euler, 0, 1}));
  EXPECT_GT(test::volume(*made.mesh), 0) << "faces must look outwards";
}

std::vector<Case> cases() {
  const std::pair<const char*, long> shapes[] = {{"sphere", 2},  {"ellipsoid", 2}, {"torus", 0},
                                                 {"genus2", -2}, {"genus5", -8},   {"trefoil", 0}};
  std::vector<Case> all;
  for (const auto& [shape, euler] : shapes) {
    all.push_back({shape, shapes::Sampling::uniform, 0, euler});
    all.push_back({shape, shapes::Sampling::blue, 0, euler});
    all.push_back({shape, shapes::Sampling::grid, 0, euler});
    all.push_back({shape, shapes::Sampling::grid, 1e-7, euler});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, DelaunayCutShapes, testing::ValuesIn(cases()), [](const auto& info) {
  const Case& c = info.param;
  const char* sampling = c.sampling == shapes::Sampling::uniform ? "uniform"
                         : c.sampling == shapes::Sampling::blue  ? "blue"
                         : c.jitter > 0                          ? "jittered_grid"
                                                                 : "grid";
  return std::string(c.shape) + "_" + sampling;
});

TEST(DelaunayCut, LeavesTheHolesOfCutShapesOpen) {
  for (const char* options : {"boundary=auto", "boundary=open"})
    for (const auto& [shape, euler] : {std::pair("cut-sphere", 1L), std::pair("cut-torus", 0L)}) {
      const test::Staged s = test::staged(shapes::sample(shape, {.points = 5000, .seed = 3}));
      const Topology t = topology(*reconstruct(s, options).mesh);
      EXPECT_EQ(t.euler, euler) << shape << " " << options;
      EXPECT_EQ(t.components, 1u) << shape << " " << options;
      EXPECT_GT(t.boundary_edges, 20u) << shape << " " << options;
    }
}

TEST(DelaunayCut, RefusesAHoleWhereTheSurfaceMustBeClosed) {
  const test::Staged s = test::staged(shapes::sample("cut-torus", {.points = 5000, .seed = 3}));
  try {
    reconstruct(s, "boundary=closed");
    FAIL() << "a hole was closed";
  } catch (const SampleError& error) {
    const auto& findings = error.findings();
    const auto hole =
        std::find_if(findings.begin(), findings.end(), [](const Finding& f) { return f.code == "boundary"; });
    ASSERT_NE(hole, findings.end());
    for (const Index i : hole->elements) EXPECT_GT(s.sample.points[i].z, 0.1) << "the cut is at z = 0.2";
  }
}

TEST(DelaunayCut, RefusesASparseSampleWithTheDensityThatWouldDo) {
  try {
    reconstruct(test::staged(shapes::sample("trefoil", {.points = 1200, .seed = 1})));
    FAIL() << "1200 points do not show a trefoil";
  } catch (const SampleError& error) {
    EXPECT_NE(error.remedy().find("points as evenly spread would do"), std::string::npos) << error.what();
    EXPECT_FALSE(error.findings().empty());
  }
}

TEST(DelaunayCut, KeepsSpheresInsideEachOtherApart) {
  PointSample inner = test::sphere(1500, 1);
  for (Vec3& p : inner.points) p = 0.5 * p;
  const Reconstruction made = reconstruct(test::staged(joined(test::sphere(3000, 2), inner)));
  EXPECT_EQ(topology(*made.mesh), (Topology{4, 0, 2}));
  EXPECT_NEAR(test::volume(*made.mesh), 4.0 / 3 * std::numbers::pi * 1.125, 0.1) << "both look outwards";
}

TEST(DelaunayCut, MakesComponentsOfLinkedTori) {
  PointSample thin = test::torus(6000, 3);
  for (Vec3& p : thin.points) {  // a ring of radius 1 and thickness 0.2
    const double ring = std::hypot(p.x, p.y);
    p = {p.x / ring * (1 + 0.5 * (ring - 1)), p.y / ring * (1 + 0.5 * (ring - 1)), 0.5 * p.z};
  }
  PointSample other = thin;
  for (Vec3& p : other.points) p = {p.x + 1, p.z, p.y};
  const Reconstruction made = reconstruct(test::staged(joined(thin, other)));
  EXPECT_EQ(topology(*made.mesh), (Topology{0, 0, 2}));
}

TEST(DelaunayCut, TriangulatesPlanarPiecesInTheirPlanes) {
  PointSample plates = test::plane_lattice(15, 15);
  for (const Vec3& p : test::plane_lattice(15, 15).points) plates.points.push_back({p.x, p.y, 40});
  for (const Vec3& p : test::plane_lattice(15, 15).points) plates.points.push_back({p.x + 60, p.z, p.y});
  const Reconstruction made = reconstruct(test::staged(std::move(plates), false));
  EXPECT_EQ(topology(*made.mesh), (Topology{3, 3 * 4 * 14, 3}));
}

TEST(DelaunayCut, ClosesACubeWithSharpEdges) {
  constexpr int n = 14;
  PointSample cube;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k)
        if (i == 0 || j == 0 || k == 0 || i == n || j == n || k == n)
          cube.points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
  const Reconstruction made = reconstruct(test::staged(test::moved(std::move(cube), 0.3, {5, -2, 1}), false));
  EXPECT_EQ(topology(*made.mesh), (Topology{2, 0, 1}));
  EXPECT_NEAR(test::volume(*made.mesh), std::pow(0.3 * n, 3), 1e-9) << "every vertex is used";
}

TEST(DelaunayCut, DoesNotDependOnTheOrderOfPoints) {
  const PointSample sample = test::torus(2000, 5);
  const std::vector<Index> order = test::permutation(sample.size(), 6);
  const Reconstruction a = reconstruct(test::staged(sample, false)),
                       b = reconstruct(test::staged(test::permuted(sample, order), false));
  EXPECT_EQ(faces_of(a), faces_of(b, order));
}

TEST(DelaunayCut, DoesNotDependOnPlaceAndScale) {
  const PointSample sample = test::torus(2000, 8);
  const auto faces = faces_of(reconstruct(test::staged(sample, false)));
  for (const double scale : {1e-6, 1.0, 1e6})
    EXPECT_EQ(faces, faces_of(reconstruct(test::staged(test::moved(sample, scale, {3 * scale, -scale, scale}), false))))
        << "scale " << scale;
}

TEST(DelaunayCut, GivesTheSameBytesForAnyNumberOfThreads) {
  const test::Staged s = test::staged(shapes::sample("genus2", {.points = 4000, .seed = 2}));
  const Reconstruction one = reconstruct(s, "", 1), three = reconstruct(s, "", 3);
  EXPECT_TRUE(std::ranges::equal(one.mesh->triangles(), three.mesh->triangles()));
  EXPECT_EQ(one.sample_of_vertex, three.sample_of_vertex);
}

}  // namespace
}  // namespace geodrome
