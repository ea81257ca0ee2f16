// SPDX-License-Identifier: MIT
// What the point stages compute does not depend on where the sample is, how it is turned, its unit, or the order of
// points.
#include <gtest/gtest.h>

#include <string>

#include "plugins/control_lipschitz/lipschitz_control.hpp"
#include "plugins/decimator_greedy/greedy_decimation.hpp"
#include "plugins/tangent_pca/pca_tangents.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/threads_context.hpp"

namespace geodrome {
namespace {

Control control_of(const PointSample& sample, unsigned threads = 2) {
  test::ThreadsContext context(threads);
  const Tangents tangents = PcaTangents(OptionValues(pca_options)).estimate(sample, context);
  return LipschitzControl(OptionValues(lipschitz_options)).evaluate(sample, tangents, context);
}

struct Case {
  std::string name;
  PointSample sample;
};

std::vector<Case> cases() {
  return {{"torus", test::torus(2000, 1)},
          {"uneven torus", test::torus(2000, 2, 10)},
          {"noisy ellipsoid", test::with_noise(test::ellipsoid(2000, 3), 0.05, 4)},
          {"plane", test::plane(1000, 5)},
          {"grid", test::plane_lattice(30, 40)}};
}

void expect_psi(const Case& c, const Control& control, const std::vector<double>& expected, double tolerance) {
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_NEAR(control.psi[i], expected[i], tolerance * expected[i]) << c.name << ' ' << i;
}

TEST(SampleInvariance, PsiTurnsAndScalesWithTheSample) {
  for (const Case& c : cases()) {
    const Control original = control_of(c.sample);
    for (const double scale : {1e-6, 1.0, 1e6}) {
      std::vector<double> expected;
      for (const double psi : original.psi) expected.push_back(scale * psi);
      const Control control = control_of(test::moved(c.sample, scale, scale * Vec3{1, -2, 3}));
      expect_psi(c, control, expected, 1e-9);
      ASSERT_EQ(control.state, original.state) << c.name;
    }
  }
}

TEST(SampleInvariance, PsiMovesFarAwayWithTheSample) {
  // The coordinates themselves are rounded to 1e-10 there, some 1e-8 of the spacing.
  for (const Case& c : cases()) {
    const Control original = control_of(c.sample);
    expect_psi(c, control_of(test::moved(c.sample, 1, {1e6, 1e6, -1e6})), original.psi, 1e-6);
  }
}

TEST(SampleInvariance, PsiBelongsToThePointNotToItsIndex) {
  for (const Case& c : cases()) {
    const std::vector<Index> order = test::permutation(c.sample.size(), 7);
    const Control original = control_of(c.sample);
    std::vector<double> expected;
    for (const Index i : order) expected.push_back(original.psi[i]);
    expect_psi(c, control_of(test::permuted(c.sample, order)), expected, 1e-9);
  }
}

TEST(SampleInvariance, TheNumberOfThreadsChangesNoBit) {
  for (const Case& c : cases()) {
    const Control one = control_of(c.sample, 1), four = control_of(c.sample, 4);
    ASSERT_EQ(one.phi, four.phi) << c.name;
    ASSERT_EQ(one.psi, four.psi) << c.name;
    test::ThreadsContext one_thread(1), four_threads(4);
    ASSERT_EQ(GreedyDecimation().select(c.sample, one, one_thread),
              GreedyDecimation().select(c.sample, four, four_threads))
        << c.name;
  }
}

}  // namespace
}  // namespace geodrome
