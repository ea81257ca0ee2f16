// SPDX-License-Identifier: MIT
#include "plugins/control_lipschitz/lipschitz_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "plugins/common/parallel_for.hpp"
#include "plugins/tangent_pca/pca_tangents.hpp"
#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

class Context : public QuietContext {
 public:
  unsigned threads() const noexcept override { return 2; }
};

Tangents tangents_of(const PointSample& sample) {
  Context context;
  return PcaTangents(OptionValues(pca_options)).estimate(sample, context);
}

Control control_of(const PointSample& sample, const Tangents& tangents, const char* options = "") {
  Context context;
  return LipschitzControl(OptionValues(lipschitz_options, options)).evaluate(sample, tangents, context);
}

/// The cell of one point by plain Sutherland-Hodgman clipping with every other point in the order of their indices, in
/// long double: nothing in common with the product but the definition.
struct PlainCell {
  struct Corner {
    long double x, y;
    bool cut_edge;  ///< the edge that leaves the corner is a bisector
  };
  std::vector<Corner> corners;

  void cut(long double a, long double b, long double c) {
    std::vector<Corner> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &p = corners[i], &q = corners[(i + 1) % corners.size()];
      const long double fp = a * p.x + b * p.y - c, fq = a * q.x + b * q.y - c;
      const long double t = fp / (fp - fq);
      const Corner crossing{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.cut_edge};
      if (fp <= 0) result.push_back(p);
      if (fp <= 0 && fq > 0) result.push_back({crossing.x, crossing.y, true});
      if (fp > 0 && fq <= 0) result.push_back(crossing);
    }
    corners = result;
  }
};

struct PlainRadius {
  long double phi = 0;
  bool bounded = true;
};

PlainRadius plain_phi(const PointSample& sample, std::size_t site, const Vec3& normal, long double reach) {
  Vec3 u = cross(normal, {0.3, 0.5, 0.8});
  u = u / norm(u);
  const Vec3 v = cross(normal, u);
  PlainCell cell{{{reach, -reach, false}, {reach, reach, false}, {-reach, reach, false}, {-reach, -reach, false}}};
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (i == site) continue;
    const Vec3 d = sample.points[i] - sample.points[site];
    cell.cut(2 * dot(d, u), 2 * dot(d, v), squared_norm(d));
  }
  PlainRadius result;
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const auto& arriving = cell.corners[(i + cell.corners.size() - 1) % cell.corners.size()];
    const auto& c = cell.corners[i];
    const long double distance = std::sqrt(c.x * c.x + c.y * c.y);
    if (arriving.cut_edge && c.cut_edge && distance <= reach)
      result.phi = std::max(result.phi, distance);
    else
      result.bounded = false;
  }
  return result;
}

long double reach_of(const PointSample& sample) {
  Vec3 sum;
  for (const Vec3& p : sample.points) sum = sum + (p - sample.points[0]);
  const Vec3 centroid = sample.points[0] + sum / static_cast<double>(sample.size());
  double reach = 0;
  for (const Vec3& p : sample.points) reach = std::max(reach, 2 * distance(p, centroid));
  return reach;
}

void expect_phi_is_plain(const std::string& name, const PointSample& sample) {
  const Tangents tangents = tangents_of(sample);
  const Control control = control_of(sample, tangents, "cap=off");
  const long double reach = reach_of(sample);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const PlainRadius plain = plain_phi(sample, i, tangents.plane[i].normal, reach);
    ASSERT_NEAR(control.phi[i], static_cast<double>(plain.phi), 1e-12 * static_cast<double>(plain.phi))
        << name << ' ' << i;
    ASSERT_EQ(control.state[i] == PointState::unbounded, !plain.bounded) << name << ' ' << i;
  }
}

TEST(ControlLipschitz, PhiIsTheFarthestVertexOfTheCutVoronoiCell) {
  expect_phi_is_plain("torus", test::torus(1500, 1));
  expect_phi_is_plain("uneven torus", test::torus(1500, 2, 10));
  expect_phi_is_plain("ellipsoid", test::ellipsoid(1500, 3));
  expect_phi_is_plain("noisy torus", test::with_noise(test::torus(1000, 4), 0.1, 5));
  expect_phi_is_plain("plane", test::plane(1500, 6));
  expect_phi_is_plain("cube", test::cube(1000, 7));
  expect_phi_is_plain("grid", test::plane_lattice(30, 20));
  expect_phi_is_plain("turned grid", test::moved(test::plane_lattice(20, 30), 1, {0, 0, 0}));
  expect_phi_is_plain("small torus", test::moved(test::torus(800, 8), 1e-6, {0, 0, 0}));
  expect_phi_is_plain("large torus", test::moved(test::torus(800, 9), 1e6, {0, 0, 0}));
  expect_phi_is_plain("far torus", test::moved(test::torus(800, 10), 1, {1e6, 1e6, -1e6}));
}

TEST(ControlLipschitz, PhiOfALatticeIsHalfItsDiagonal) {
  const PointSample sample = test::plane_lattice(20, 20);
  const Control control = control_of(sample, tangents_of(sample), "cap=off");
  for (const double phi : control.phi) ASSERT_NEAR(phi, std::sqrt(0.5), 1e-14);
}

TEST(ControlLipschitz, ExactlyTheBorderOfALatticeIsUnbounded) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const PointSample sample = test::moved(test::plane_lattice(30, 20), scale, {});
    const Control control = control_of(sample, tangents_of(sample));
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const bool border = i % 30 == 0 || i % 30 == 29 || i / 30 == 0 || i / 30 == 19;
      ASSERT_EQ(control.state[i] == PointState::unbounded, border) << i;
    }
  }
}

/// Twenty samples of 2,000 to 20,000 points.
std::vector<PointSample> twenty_samples() {
  std::vector<PointSample> samples;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    samples.push_back(test::torus(2000 + 500 * seed, seed));
    samples.push_back(test::torus(4000, seed, 10));
    samples.push_back(test::ellipsoid(3000 + 1000 * seed, seed));
    samples.push_back(test::cube(3000, seed));
    samples.push_back(test::plane(4000, seed));
  }
  samples.push_back(test::plane_lattice(60, 70));
  samples.push_back(test::moved(test::torus(3000, 4), 1e-6, {}));
  samples.push_back(test::moved(test::ellipsoid(3000, 5), 1e6, {1e6, 0, 0}));
  samples.push_back(test::with_noise(test::torus(5000, 6), 0.2, 7));
  samples.push_back(test::torus(20000, 8, 10));
  return samples;
}

TEST(ControlLipschitz, PsiIsBitwiseThatOfTheDoubleLoop) {
  const std::vector<PointSample> samples = twenty_samples();
  ASSERT_EQ(samples.size(), 20U);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const PointSample& sample = samples[k];
    // Without the cap single large values reach far, which is the harder case.
    const Control control = control_of(sample, tangents_of(sample), k % 2 ? "cap=on" : "cap=off");
    std::vector<double> plain(sample.size());
    Context context;
    parallel_for(sample.size(), context, {}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double best = -1;
        for (std::size_t j = 0; j < sample.size(); ++j)
          best = std::max(best, phi_factor * control.phi[j] - psi_slope * distance(sample.points[i], sample.points[j]));
        plain[i] = best;
      }
    });
    ASSERT_EQ(control.psi, plain) << "sample " << k;
  }
}

TEST(ControlLipschitz, PsiIsOneEighteenthLipschitz) {
  test::Random random(1);
  for (const PointSample& sample : {test::torus(5000, 1, 10), test::with_noise(test::ellipsoid(3000, 2), 0.3, 3)}) {
    const Control control = control_of(sample, tangents_of(sample));
    for (int trial = 0; trial < 200000; ++trial) {
      const std::size_t i = random.below(sample.size()), j = random.below(sample.size());
      ASSERT_LE(std::abs(control.psi[i] - control.psi[j]), distance(sample.points[i], sample.points[j]) / 18);
    }
  }
}

TEST(ControlLipschitz, PsiIsAtLeastFiveSigmaOfTheNoiseAndOtherwiseAsItWas) {
  const PointSample sample = test::torus(3000, 4, 10);
  Tangents tangents = tangents_of(sample);
  const Control clean = control_of(sample, tangents);
  std::vector<double> sorted = clean.psi;
  std::nth_element(sorted.begin(), sorted.begin() + 1500, sorted.end());
  tangents.sigma = sorted[1500] / 5;
  const Control noisy = control_of(sample, tangents);
  EXPECT_EQ(noisy.phi, clean.phi);
  for (std::size_t i = 0; i < sample.size(); ++i) ASSERT_EQ(noisy.psi[i], std::max(clean.psi[i], 5 * tangents.sigma));
}

TEST(ControlLipschitz, OneOutlierDoesNotDecidePsiEverywhere) {
  PointSample sample = test::torus(3000, 1);
  sample.points.push_back({0, 0, 3});
  const Tangents tangents = tangents_of(sample);
  const Control capped = control_of(sample, tangents), literal = control_of(sample, tangents, "cap=off");
  const auto largest = [](const Control& c) { return *std::max_element(c.psi.begin(), c.psi.end()); };
  EXPECT_GT(largest(literal), 3 * largest(capped));
  EXPECT_LT(largest(capped), 0.4);
}

TEST(ControlLipschitz, CapIsOneAndAHalfMediansOfTheSeventeenNearest) {
  const PointSample sample = test::torus(1000, 5);
  const Tangents tangents = tangents_of(sample);
  const Control capped = control_of(sample, tangents), literal = control_of(sample, tangents, "cap=off");
  std::size_t count = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    std::vector<std::pair<double, double>> by_distance;
    for (std::size_t j = 0; j < sample.size(); ++j)
      if (j != i) by_distance.emplace_back(distance(sample.points[i], sample.points[j]), literal.phi[j]);
    std::sort(by_distance.begin(), by_distance.end());
    std::vector<double> phi;
    for (std::size_t j = 0; j < 17; ++j) phi.push_back(by_distance[j].second);
    std::sort(phi.begin(), phi.end());
    ASSERT_EQ(capped.phi[i], std::min(literal.phi[i], 1.5 * phi[8]));
    ASSERT_EQ(capped.state[i] == PointState::capped, capped.phi[i] < literal.phi[i]);
    count += capped.state[i] == PointState::capped;
  }
  EXPECT_GT(count, 0U);
}

TEST(ControlLipschitz, ThreePointsHaveTheirCircumradius) {
  const PointSample sample{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}};
  const Control control = control_of(sample, tangents_of(sample), "cap=off");
  for (const double phi : control.phi) EXPECT_NEAR(phi, 2.5, 1e-14);
}

TEST(ControlLipschitz, ACellWithoutVertexTakesItsFarthestEdge) {
  // The circumcentre of three points near a line is farther than the sample is wide.
  const PointSample sample{{{0, 0, 0}, {1, 1e-3, 0}, {3, 0, 0}}};
  const Control control = control_of(sample, tangents_of(sample), "cap=off");
  EXPECT_NEAR(control.phi[1], 1, 1e-6);
  EXPECT_EQ(control.state[1], PointState::unbounded);
}

TEST(ControlLipschitz, ACellThatNothingLimitsIsRefusedByName) {
  const PointSample sample{{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}};
  Tangents tangents;
  for (const Vec3& p : sample.points) tangents.plane.push_back({p, {0, 0, 1}, 0});
  tangents.state.assign(3, PointState::ok);
  try {
    control_of(sample, tangents);
    FAIL();
  } catch (const SampleError& error) {
    EXPECT_NE(std::string(error.what()).find("point 0"), std::string::npos);
  }
}

TEST(ControlLipschitz, APointFarFromACrowdFindsItsNeighboursBeyondTheCrowd) {
  // More than 64 near points on one side, the cell's other edges from far away: the search goes on at the corners.
  PointSample sample{{{0, 0, 0}, {50, 0, 0}, {-50, 40, 0}, {-50, -40, 0}}};
  test::Random random(3);
  for (int i = 0; i < 500; ++i) sample.points.push_back({10 + random.uniform(), random.uniform(-1, 1), 0});
  Tangents tangents;
  for (const Vec3& p : sample.points) tangents.plane.push_back({p, {0, 0, 1}, 0});
  tangents.state.assign(sample.size(), PointState::ok);
  const Control control = control_of(sample, tangents, "cap=off");
  const PlainRadius plain = plain_phi(sample, 0, {0, 0, 1}, reach_of(sample));
  EXPECT_TRUE(plain.bounded);
  EXPECT_EQ(control.state[0], PointState::ok);
  EXPECT_NEAR(control.phi[0], static_cast<double>(plain.phi), 1e-12 * static_cast<double>(plain.phi));
}

}  // namespace
}  // namespace geodrome
