// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "plugins/reconstructor_delaunay_cut/delaunay_cut.hpp"
#include "plugins/solver_chen_han/chen_han.hpp"
#include "tests/support/sample_stages.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/threads_context.hpp"
#include "tests/support/topology.hpp"
#include "tools/shapes/shapes.hpp"
#include "tools/shapes/sheets.hpp"

namespace geodrome {
namespace {

using shapes::Sampling;

Reconstruction reconstruct(const test::Staged& s, const char* options = "", unsigned threads = 2) {
  test::ThreadsContext context(threads);
  return DelaunayCut(OptionValues(DelaunayCut::options, options))
      .reconstruct(s.sample, s.tangents, s.control, s.kept, context);
}

/// A sheet is a disk. The chord of half a circle is shorter than its arc by pi / 2: longer ways join two turns.
void expect_sheet(const char* shape, const SurfaceMesh& mesh) {
  const test::Topology t = test::topology(mesh);
  EXPECT_EQ(t.euler, 1);
  EXPECT_EQ(t.components, 1u);
  EXPECT_GT(t.boundary_edges, 20u);
  double longest = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Vec3 &a = mesh.positions()[mesh.from(h)], &b = mesh.positions()[mesh.to(h)];
    longest = std::max(longest, shapes::sheet_distance(shape, a, b) / distance(a, b));
  }
  EXPECT_LT(longest, 1.6);
}

struct Case {
  const char* shape;
  Sampling sampling;
  double jitter;
};

class Sheets : public testing::TestWithParam<Case> {};

TEST_P(Sheets, ComeOutWholeWithTheirTurnsApart) {
  const auto& [shape, sampling, jitter] = GetParam();
  for (const std::size_t points : {800, 1600, 5000})
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(testing::Message() << points << " points, seed " << seed);
      const test::Staged s =
          test::staged(shapes::sample(shape, {.points = points, .sampling = sampling, .seed = seed, .jitter = jitter}));
      expect_sheet(shape, *reconstruct(s).mesh);
    }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* shape : {"swiss-roll", "s-curve", "slit-pipe", "plane"})
    for (const auto& [sampling, jitter] : {std::pair(Sampling::uniform, 0.0), std::pair(Sampling::grid, 0.0),
                                           std::pair(Sampling::grid, 0.3), std::pair(Sampling::blue, 0.0)})
      all.push_back({shape, sampling, jitter});
  return all;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
  const Case& c = info.param;
  std::string name = c.shape;
  std::erase(name, '-');
  return name + (c.sampling == Sampling::uniform ? "_uniform"
                 : c.sampling == Sampling::blue  ? "_blue"
                 : c.jitter > 0                  ? "_loose_grid"
                                                 : "_grid");
}

INSTANTIATE_TEST_SUITE_P(Every, Sheets, testing::ValuesIn(cases()), case_name);

/// Of `turns` turns, 2 pi apart, from radius 1.5 pi on, 21 high; uniform.
PointSample roll(double turns, std::size_t points, std::uint64_t seed) {
  test::Random random(seed);
  const double begin = 1.5 * std::numbers::pi, end = begin + 2 * std::numbers::pi * turns;
  PointSample sample;
  while (sample.size() < points) {
    const double t = random.uniform(begin, end), y = random.uniform(0, 21);
    if (random.uniform(0, std::hypot(1, end)) > std::hypot(1, t)) continue;
    sample.points.push_back({t * std::cos(t), y, t * std::sin(t)});
  }
  return sample;
}

/// The distance in the surface between two points of the sample, both vertices.
double distance_between(const Reconstruction& made, Index a, Index b) {
  const auto vertex = [&](Index s) {
    return static_cast<Index>(std::ranges::find(made.sample_of_vertex, s) - made.sample_of_vertex.begin());
  };
  EXPECT_LT(std::max(vertex(a), vertex(b)), made.mesh->vertex_count()) << "a point has no vertex";
  const ChenHanSolver solver{OptionValues(ChenHanSolver::options)};
  return distances(solver, made.mesh, made.mesh->at_vertex(vertex(a)))[vertex(b)];
}

TEST(SheetDistances, GoAlongARollAndNotAcrossIt) {
  // Six rows of 150 points 0.6 apart along a spiral whose turns are 2 pi apart.
  PointSample roll;
  std::vector<double> turn{1.5 * std::numbers::pi};
  for (int i = 1; i < 150; ++i) turn.push_back(turn.back() + 0.6 / std::hypot(1, turn.back() + 0.3 / turn.back()));
  for (int row = 0; row < 6; ++row)
    for (const double t : turn) roll.points.push_back({t * std::cos(t), 0.6 * row, t * std::sin(t)});
  const double truth = shapes::sheet_distance("swiss-roll", roll.points[0], roll.points[149]);
  ASSERT_NEAR(truth, 149 * 0.6, 0.01);
  EXPECT_NEAR(distance_between(reconstruct(test::staged(roll)), 0, 149), truth, 0.01 * truth);
}

TEST(SheetDistances, AreWithinOnePercentAlongRollsOfFourThousandPoints) {
  for (const char* shape : {"swiss-roll", "s-curve"}) {
    const test::Staged s = test::staged(shapes::sample(shape, {.points = 4000, .seed = 11}));
    const Reconstruction made = reconstruct(s);
    const auto along = [&](Index p) { return shapes::unrolled(shape, s.sample.points[p]).along; };
    const Index first = *std::ranges::min_element(made.sample_of_vertex, {}, along);
    const Index last = *std::ranges::max_element(made.sample_of_vertex, {}, along);
    const double truth = shapes::sheet_distance(shape, s.sample.points[first], s.sample.points[last]);
    EXPECT_NEAR(distance_between(made, first, last), truth, 0.01 * truth) << shape;
  }
}

TEST(SheetRefusals, NameADensityThatDoes) {
  std::size_t wanted = 0;
  try {
    reconstruct(test::staged(roll(3, 800, 1)));
    FAIL() << "800 points do not show three turns";
  } catch (const SampleError& error) {
    ASSERT_EQ(error.remedy().rfind("about ", 0), 0u) << error.remedy();
    wanted = std::stoul(error.remedy().substr(6));
  }
  EXPECT_LE(wanted, 6000u);
  EXPECT_EQ(test::topology(*reconstruct(test::staged(roll(3, wanted, 2))).mesh).euler, 1);
}

TEST(SheetRefusals, OfAMoebiusStripSayThatItIsOneSided) {
  test::Random random(5);
  PointSample strip;
  while (strip.size() < 3000) {
    const double a = random.uniform(0, 2 * std::numbers::pi), w = random.uniform(-0.6, 0.6);
    const double r = 2 + w * std::cos(a / 2);
    strip.points.push_back({r * std::cos(a), r * std::sin(a), w * std::sin(a / 2)});
  }
  try {
    reconstruct(test::staged(strip));
    FAIL() << "the strip has no two sides";
  } catch (const SampleError& error) {
    EXPECT_NE(error.message().find("one-sided"), std::string::npos) << error.message();
    EXPECT_TRUE(std::ranges::any_of(error.findings(), [](const Finding& f) { return f.code == "one_sided"; }));
  }
  // Cut open, it has.
  std::erase_if(strip.points, [](const Vec3& p) { return p.x > 0 && std::abs(p.y) < 0.2; });
  EXPECT_EQ(test::topology(*reconstruct(test::staged(strip)).mesh).euler, 1);
}

TEST(SheetsBesideSolids, KeepTheirRimsAndTheSolidsNone) {
  PointSample both = shapes::sample("s-curve", {.points = 2000, .seed = 4});
  for (const Vec3& p : test::sphere(2000, 5).points) both.points.push_back(p + Vec3{10, 0, 0});
  const test::Topology t = test::topology(*reconstruct(test::staged(both)).mesh);
  EXPECT_EQ(t.euler, 1 + 2);
  EXPECT_EQ(t.components, 2u);
}

TEST(SheetsOfFewPoints, KeepTheHolesOfCutShapesThatAClosedSurfaceWouldFill) {
  for (const auto& [shape, euler] : {std::pair("cut-sphere", 1L), std::pair("cut-torus", 0L)})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const test::Topology t =
          test::topology(*reconstruct(test::staged(shapes::sample(shape, {.points = 1000, .seed = seed}))).mesh);
      EXPECT_EQ(t.euler, euler) << shape << " " << seed;
      EXPECT_GT(t.boundary_edges, 20u) << shape << " " << seed;
    }
}

TEST(SheetFaces, DoNotDependOnTheOrderOfPoints) {
  const PointSample sample = shapes::sample("s-curve", {.points = 1500, .seed = 6});
  const std::vector<Index> order = test::permutation(sample.size(), 7);
  EXPECT_EQ(test::faces_of(reconstruct(test::staged(sample, false))),
            test::faces_of(reconstruct(test::staged(test::permuted(sample, order), false)), order));
}

TEST(SheetFaces, DoNotDependOnPlaceAndScale) {
  const PointSample sample = shapes::sample("s-curve", {.points = 1500, .seed = 8});
  const auto faces = test::faces_of(reconstruct(test::staged(sample, false)));
  for (const double scale : {1e-6, 1e6})
    EXPECT_EQ(faces,
              test::faces_of(reconstruct(test::staged(test::moved(sample, scale, {3 * scale, -scale, scale}), false))))
        << "scale " << scale;
}

TEST(SheetFaces, AreTheSameBytesForAnyNumberOfThreads) {
  const test::Staged s = test::staged(shapes::sample("swiss-roll", {.points = 2000, .sampling = Sampling::grid}));
  const Reconstruction one = reconstruct(s, "", 1), three = reconstruct(s, "", 3);
  EXPECT_TRUE(std::ranges::equal(one.mesh->triangles(), three.mesh->triangles()));
  EXPECT_EQ(one.sample_of_vertex, three.sample_of_vertex);
}

}  // namespace
}  // namespace geodrome
