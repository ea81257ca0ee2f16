// SPDX-License-Identifier: MIT
#include "engine/input/ear_clipping.hpp"

#include <gtest/gtest.h>

namespace geodrome::testing {
namespace {

TEST(EarClipping, RefusesAWalkThatHasNoEars) {
  const std::vector<input::GridPoint> clockwise = {{0, 0}, {0, 4}, {4, 4}, {4, 0}};
  EXPECT_FALSE(input::bounds_one_region(clockwise));
  EXPECT_FALSE(input::clip_ears(clockwise, std::vector<input::PlanePoint>{{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
}

TEST(EarClipping, IsExactOnTheGrid) {
  constexpr std::int64_t far = std::int64_t{1} << 51;
  using input::GridPoint;
  EXPECT_EQ(input::doubled_area({-far, -far}, {far, far}, {0, 0}), 0);
  EXPECT_GT(input::doubled_area({-far, -far}, {far, far - 1}, {0, 0}), 0);
  EXPECT_LT(input::doubled_area({-far, -far}, {far, far}, {1, 0}), 0);
}

}  // namespace
}  // namespace geodrome::testing
