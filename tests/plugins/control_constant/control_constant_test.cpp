// SPDX-License-Identifier: MIT
#include "plugins/control_constant/constant_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plugins/decimator_greedy/greedy_decimation.hpp"
#include "plugins/reconstructor_delaunay_cut/delaunay_cut.hpp"
#include "plugins/tangent_jet/jet_tangents.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/topology.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

/// Nothing of the tangents matters but sigma and what is dropped.
Tangents tangents_of(const PointSample& sample, double sigma = 0) {
  Tangents tangents;
  for (const Vec3& p : sample.points) tangents.plane.push_back({p, {0, 0, 1}, 0});
  tangents.state.assign(sample.size(), PointState::ok);
  tangents.sigma = sigma;
  return tangents;
}

Control control_of(const PointSample& sample, const Tangents& tangents, const char* options = "") {
  QuietContext context;
  return ConstantControl(OptionValues(constant_options, options)).evaluate(sample, tangents, context);
}

double psi_of(const PointSample& sample) { return control_of(sample, tangents_of(sample)).psi.front(); }

/// By the definition, over all pairs.
double plain_spacing(const PointSample& sample) {
  std::vector<double> sixth;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    std::vector<double> others;
    for (std::size_t j = 0; j < sample.size(); ++j)
      if (j != i) others.push_back(distance(sample.points[i], sample.points[j]));
    std::sort(others.begin(), others.end());
    sixth.push_back(others[5]);
  }
  std::sort(sixth.begin(), sixth.end());
  return sixth[(sixth.size() - 1) / 2];
}

TEST(ControlConstant, PsiAndPhiAreAShareOfTheMedianDistanceOfTheSixthNeighbourEverywhere) {
  for (const PointSample& sample : {test::torus(1000, 1), test::ellipsoid(801, 2), test::plane(500, 3)}) {
    const Control control = control_of(sample, tangents_of(sample));
    const double wanted = 0.8 * plain_spacing(sample);
    for (std::size_t i = 0; i < sample.size(); ++i) {
      ASSERT_DOUBLE_EQ(control.phi[i], wanted);
      ASSERT_EQ(control.psi[i], control.phi[0]);
      ASSERT_EQ(control.state[i], PointState::ok);
    }
  }
}

TEST(ControlConstant, TheSpacingOfALatticeIsItsDiagonal) {
  EXPECT_DOUBLE_EQ(psi_of(test::plane_lattice(40, 40)), 0.8 * std::sqrt(2));
}

TEST(ControlConstant, TheSpacingGrowsWithTheSample) {
  const PointSample sample = test::torus(1500, 4);
  const double psi = psi_of(sample);
  for (const double scale : {1e-6, 3.0, 1e6})
    EXPECT_NEAR(psi_of(test::moved(sample, scale, {scale, 2 * scale, -scale})), scale * psi, 1e-9 * scale * psi);
}

TEST(ControlConstant, OutliersAndACrowdHardlyMoveIt) {
  PointSample sample = test::torus(3000, 5);
  const double psi = psi_of(sample);
  test::Random random(6);
  for (int i = 0; i < 50; ++i) sample.points.push_back(1e3 * random.direction());
  EXPECT_NEAR(psi_of(sample), psi, 0.02 * psi);
  for (int i = 0; i < 300; ++i) sample.points.push_back(Vec3{1.4, 0, 0} + 1e-3 * random.direction());
  EXPECT_NEAR(psi_of(sample), psi, 0.1 * psi);
}

TEST(ControlConstant, TakesTheGivenValue) {
  const PointSample sample = test::torus(100, 7);
  const Control control = control_of(sample, tangents_of(sample), "value=0.125");
  EXPECT_EQ(control.phi, std::vector(100, 0.125));
  EXPECT_EQ(control.psi, std::vector(100, 0.125));
  for (const char* wrong : {"value=-1", "value=nan", "value=inf", "value=x"})
    EXPECT_THROW(control_of(sample, tangents_of(sample), wrong), OptionError) << wrong;
}

TEST(ControlConstant, PsiIsAtLeastFiveSigmaOfTheNoise) {
  const PointSample sample = test::torus(100, 8);
  const Control below = control_of(sample, tangents_of(sample, 0.02), "value=0.125");
  EXPECT_EQ(below.psi, std::vector(100, 0.125));
  const Control above = control_of(sample, tangents_of(sample, 0.03), "value=0.125");
  EXPECT_EQ(above.phi, std::vector(100, 0.125));
  EXPECT_EQ(above.psi, std::vector(100, 5 * 0.03));
}

TEST(ControlConstant, RefusesASampleWithoutSpacingUnlessTheValueIsGiven) {
  const PointSample one{{{1, 2, 3}}}, heap{std::vector<Vec3>(20, {1, 2, 3})};
  for (const PointSample& sample : {one, heap}) {
    EXPECT_THROW(control_of(sample, tangents_of(sample)), SampleError);
    EXPECT_EQ(control_of(sample, tangents_of(sample), "value=2").psi.back(), 2);
  }
}

TEST(ControlConstant, TwoPointsHaveTheirDistance) { EXPECT_DOUBLE_EQ(psi_of({{{0, 0, 0}, {0, 3, 4}}}), 0.8 * 5); }

TEST(ControlConstant, SaysNothingOfASampleThatWasDroppedWhole) {
  const PointSample sample = test::torus(50, 9);
  Tangents tangents = tangents_of(sample);
  tangents.state.assign(50, PointState::dropped);
  for (const double psi : control_of(sample, tangents).psi) EXPECT_TRUE(std::isnan(psi));
}

TEST(ControlConstant, MakesSurfacesOfTheRightTopology) {
  for (const auto& [shape, euler] : {std::pair("sphere", 2L), std::pair("torus", 0L), std::pair("genus2", -2L)})
    for (const auto sampling : {shapes::Sampling::uniform, shapes::Sampling::blue, shapes::Sampling::grid}) {
      PointSample sample = shapes::sample(shape, {.points = 3000, .sampling = sampling, .seed = 7});
      QuietContext context;
      const Tangents tangents = JetTangents(OptionValues(jet_options, "")).estimate(sample, context);
      for (std::size_t i = 0; i < sample.size(); ++i) sample.points[i] = tangents.plane[i].origin;
      const Control control = control_of(sample, tangents);
      const std::vector<Index> kept = GreedyDecimation().select(sample, control, context);
      const Reconstruction made =
          DelaunayCut(OptionValues(DelaunayCut::options)).reconstruct(sample, tangents, control, kept, context);
      EXPECT_LT(kept.size(), sample.size() * 2 / 3) << shape;
      EXPECT_EQ(test::topology(*made.mesh), (test::Topology{euler, 0, 1})) << shape;
    }
}

}  // namespace
}  // namespace geodrome
