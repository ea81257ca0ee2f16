// SPDX-License-Identifier: MIT
#include "tools/shapes/sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shape_equations.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome {
namespace {

class Sheet : public testing::TestWithParam<std::string> {
 protected:
  Vec3 at(double u, double v) const { return shapes::find_patch(GetParam())->at(u, v).position; }
};

/// The sum of short straight steps along a line of the unit square, which is a line of the unrolled sheet if u or v
/// stays.
TEST_P(Sheet, IsUnrolledWithoutStretching) {
  constexpr int steps = 20000;
  double along = 0, across = 0;
  for (int i = 0; i < steps; ++i) {
    along += distance(at(1.0 * i / steps, 0.3), at(1.0 * (i + 1) / steps, 0.3));
    across += distance(at(0.7, 1.0 * i / steps), at(0.7, 1.0 * (i + 1) / steps));
  }
  EXPECT_NEAR(shapes::sheet_distance(GetParam(), at(0, 0.3), at(1, 0.3)), along, 1e-7 * along);
  EXPECT_NEAR(shapes::sheet_distance(GetParam(), at(0.7, 0), at(0.7, 1)), across, 1e-9 * across);
}

TEST_P(Sheet, UnrollsEveryPartOfItToItsOwnPlace) {
  for (int i = 1; i <= 1000; ++i) {
    const double before = shapes::unrolled(GetParam(), at(0.001 * (i - 1), 0.5)).along;
    const double here = shapes::unrolled(GetParam(), at(0.001 * i, 0.5)).along;
    ASSERT_GT(here, before) << i;
    ASSERT_LT(here - before, 0.2) << i;
  }
}

TEST_P(Sheet, LatticesWithJitterStayOnIt) {
  const shapes::SampleSpec exact{.points = 900, .sampling = shapes::Sampling::grid};
  shapes::SampleSpec jittered = exact;
  jittered.jitter = 0.3;
  const PointSample before = shapes::sample(GetParam(), exact), after = shapes::sample(GetParam(), jittered);
  ASSERT_EQ(before.size(), after.size());
  EXPECT_FALSE(before.points == after.points);
  for (const Vec3& p : after.points) {
    ASSERT_LE(test::distance_off_shape(GetParam(), p), 1e-12);
    ASSERT_TRUE(test::within_borders(GetParam(), p));
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Sheet, testing::ValuesIn(shapes::sheet_kinds()), test_name);

TEST(Sheets, HaveTheLengthsThatTheirFormulasGive) {
  const auto length = [](const char* kind) {
    const shapes::Patch& patch = *shapes::find_patch(kind);
    return shapes::sheet_distance(kind, patch.at(0, 0).position, patch.at(1, 0).position);
  };
  EXPECT_NEAR(length("swiss-roll"), 89.373, 1e-3);
  EXPECT_NEAR(length("s-curve"), 3 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(length("slit-pipe"), 2 * std::numbers::pi - 0.75, 1e-12);
}

TEST(Sheets, RefuseWhatCannotBeUnrolled) {
  EXPECT_THROW(shapes::unrolled("torus", {1.4, 0, 0}), OptionError);
  EXPECT_THROW(shapes::sample("torus", {.jitter = 0.5}), OptionError);
  EXPECT_THROW(shapes::sample("genus2", {.sampling = shapes::Sampling::grid, .jitter = 0.1}), OptionError);
}

}  // namespace
}  // namespace geodrome
