// SPDX-License-Identifier: MIT
#include "plugins/common/exact/ordered_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/plugins/common/images.hpp"
#include "tests/plugins/common/window_pairs.hpp"

/// The lemma of ordered neighbours, over the images of both exact solvers.
namespace geodrome::chen_han::test {
namespace {

template <class Image>
class OrderedPair : public testing::Test {};
TYPED_TEST_SUITE(OrderedPair, Images, ImageNames);

bool holds(const Interval& interval, double x) { return interval.low <= x && x <= interval.high; }

/// Of each place that both have the nearer keeps it and the other does not; all else stays. What is lost otherwise has
/// a shorter way that bends.
TYPED_TEST(OrderedPair, GivesEachPlaceToTheNearerOfTwoInOrder) {
  int cut = 0, reversed = 0, dropped = 0;
  for_each_pair([&](const Scene& scene, const Entered& first, const Entered& second, Random& random) {
    const Window &a = first.window, &b = second.window;
    Interval l = interval_of(a), r = interval_of(b);
    const PairOrder order = settle_pair(image_of<TypeParam>(a), l, image_of<TypeParam>(b), r);
    ASSERT_NE(order, PairOrder::tangled);
    if (order == PairOrder::drop_left) l.high = l.low;
    if (order == PairOrder::drop_right) r.low = r.high;
    cut += order == PairOrder::cut, dropped += order == PairOrder::drop_left || order == PairOrder::drop_right;
    reversed += a.low >= b.high;
    ASSERT_TRUE(l.low == a.low && l.high <= a.high && r.low >= b.low && r.high == b.high) << "an interval grew";
    for (const double x : sample_places(scene.length, {a.low, a.high, b.low, b.high, l.high, r.low}, random)) {
      const bool in_a = holds(interval_of(a), x), in_b = holds(interval_of(b), x);
      const double near = std::min(first.bent(x), second.bent(x)) * (1 - scene.noise());
      const double of_a = a.at(x), of_b = b.at(x), noise = scene.noise() * of_a;
      if (in_a && of_a < near && !(in_b && of_b < of_a + noise)) {
        ASSERT_TRUE(holds(l, x)) << "left at " << x;
      }
      if (in_b && of_b < near && !(in_a && of_a < of_b + noise)) {
        ASSERT_TRUE(holds(r, x)) << "right at " << x;
      }
      if (in_a && in_b && of_a < near && of_b < near) {
        ASSERT_TRUE(holds(l, x) || holds(r, x)) << "nobody at " << x;
      }
      ASSERT_FALSE(holds(l, x) && in_b && of_b < of_a - noise) << "right is nearer at " << x;
      ASSERT_FALSE(holds(r, x) && in_a && of_a < of_b - noise) << "left is nearer at " << x;
    }
  });
  EXPECT_GT(cut, 1000);
  EXPECT_GT(reversed, 100);
  EXPECT_GT(dropped, 100);
}

TYPED_TEST(OrderedPair, CutsMirroredOnesInTheMiddle) {
  const TypeParam a = image_of<TypeParam>({0, -1, 0, 0, 2, 0, 0}), b = image_of<TypeParam>({2, -1, 0, 0, 2, 1, 0});
  Interval l{0, 2}, r{0, 2};
  EXPECT_EQ(settle_pair(a, l, b, r), PairOrder::cut);
  EXPECT_DOUBLE_EQ(l.high, 1);
  EXPECT_EQ(l.high, r.low);
}

TYPED_TEST(OrderedPair, LeavesThoseThatDoNotOverlap) {
  const TypeParam a = image_of<TypeParam>({0, -1, 0, 0, 1, 0, 0}), b = image_of<TypeParam>({2, -1, 9, 1, 2, 1, 0});
  Interval l{0, 1}, r{1, 2};
  EXPECT_EQ(settle_pair(a, l, b, r), PairOrder::apart);
  EXPECT_TRUE(l.high == 1 && r.low == 1);
}

TYPED_TEST(OrderedPair, DropsWhatIsEmptyWhateverItsDistance) {
  const TypeParam a = image_of<TypeParam>({0, -1, 0, 0, 1, 0, 0});
  for (const double width : {0.0, -1e-16}) {
    Interval full{0, 1}, empty{0.5, 0.5 + width};
    EXPECT_EQ(settle_pair(a, empty, a, full), PairOrder::drop_left);
    EXPECT_EQ(settle_pair(a, full, a, empty), PairOrder::drop_right);
    EXPECT_TRUE(full.low == 0 && full.high == 1);
  }
}

/// Equally far everywhere: whatever the order in which their intervals lie, what they had together they still have, and
/// no more than one has any of it.
template <class Image>
void expect_shared(const Image& left, const Image& right, const std::string& which) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    std::array<double, 4> ends;
    for (double& end : ends) end = static_cast<double>(random.index(6)) / 5;
    Interval l{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])},
        r{std::min(ends[2], ends[3]), std::max(ends[2], ends[3])};
    if (l.empty() || r.empty() || r.high <= l.low) continue;
    const Interval l_before = l, r_before = r;
    const PairOrder order = settle_pair(left, l, right, r);
    const bool is_tangled = r_before.low < l_before.low && r_before.high < l_before.high;
    ASSERT_EQ(order == PairOrder::tangled, is_tangled) << which << " " << i;
    if (is_tangled) {
      ASSERT_TRUE(l.high == l_before.high && r.low == r_before.low) << "tangled ones stay for a merge";
      continue;
    }
    for (double x = 0.05; x < 1; x += 0.1) {
      ASSERT_EQ(holds(l, x) || holds(r, x), holds(l_before, x) || holds(r_before, x)) << which << " " << i << " " << x;
      ASSERT_FALSE(holds(l, x) && holds(r, x)) << which << " " << i << " " << x;
    }
  }
}

TYPED_TEST(OrderedPair, LosesNothingOfTwoEqualImages) {
  const TypeParam g = image_of<TypeParam>({0.3, -1, 2, 0, 1, 0, 0});
  expect_shared(g, g, "equal");
}

TYPED_TEST(OrderedPair, LosesNothingOfParentAndChildWhereTheHalfEdgeIsTheirLine) {
  for (const double depth : {0.0, 1e-17, 1e-12}) {
    const TypeParam parent = image_of<TypeParam>({-2, -2 * depth, 1, 0, 1, 0, 0});
    const TypeParam child = image_of<TypeParam>({-1, -depth, parent.to(-1, -depth), 0, 1, 1, 0});
    expect_shared(parent, child, "parent first");
    expect_shared(child, parent, "child first");
  }
}

/// A child whose wedge begins at the ray from its parent through it: the two touch there, and neither loses a piece.
TYPED_TEST(OrderedPair, CutsParentAndChildAtTheirCommonRay) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto [parent, child, place] = random_parent_and_child(random);
    const TypeParam a = image_of<TypeParam>(parent), b = image_of<TypeParam>(child);
    Interval l = interval_of(a), r = interval_of(b);
    const PairOrder order = settle_pair(a, l, b, r);
    ASSERT_TRUE(order == PairOrder::apart || order == PairOrder::cut) << i;
    ASSERT_NEAR(l.high, place, 1e-14) << i;
    ASSERT_NEAR(r.low, place, 1e-14) << i;
  }
}

/// All rays of the left image meet the half-edge to the right of all of the right one, so they have crossed before. The
/// image that is nearer at the crossing stays, also where each is farther than the other at the end of its own ray.
TYPED_TEST(OrderedPair, OfTwoThatCrossedBeforeTheNearerOneStays) {
  const Window left{0, -2, 0, 1.5, 2, 0, 0}, right{2, -2, 0, 0, 0.5, 1, 0};
  for (const double later : {-1e-3, 0.0, 1e-3}) {
    TypeParam a = image_of<TypeParam>(left);
    const TypeParam b = image_of<TypeParam>(right);
    a.sigma += later;
    Interval l{left.low, left.high}, r{right.low, right.high};
    EXPECT_EQ(settle_pair(a, l, b, r), later > 0 ? PairOrder::drop_left : PairOrder::drop_right) << later;
  }
}

/// Only rounding can reverse the rays of one image, and whichever were dropped, nothing else would cover its part.
TYPED_TEST(OrderedPair, LeavesEqualImagesInReversedOrderToAnEnvelope) {
  const TypeParam g = image_of<TypeParam>({0.3, -1, 2, 0, 1, 0, 0});
  for (const double gap : {0.0, 1e-16, 0.2}) {
    Interval l{0.5 + gap, 0.9}, r{0.1, 0.5};
    EXPECT_EQ(settle_pair(g, l, g, r), PairOrder::tangled) << gap;
  }
}

/// The rays do not meet: the right image is beyond the nearest ray of the left one, where order does not allow it.
TYPED_TEST(OrderedPair, OfTwoThatDoNotCrossOneIsDroppedForTheOtherAtItsOwnEnd) {
  const TypeParam left = image_of<TypeParam>({0, -1, 0, 2, 3, 0, 0});
  for (const double later : {0.0, 0.3, 1.0}) {
    const TypeParam right = image_of<TypeParam>({0, -0.1, later, 0, 1, 1, 0});
    Interval l{2, 3}, r{0, 1};
    EXPECT_EQ(settle_pair(left, l, right, r), later > 0 ? PairOrder::drop_right : PairOrder::drop_left) << later;
  }
}

}  // namespace
}  // namespace geodrome::chen_han::test
