// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "plugins/solver_chen_han/trimming.hpp"
#include "tests/plugins/common/window_scenes.hpp"
#include "tests/plugins/solver_chen_han/levels.hpp"

/// Trimming where a rule decides: ties, windows inside others, windows of no width.
namespace geodrome::chen_han::test {
namespace {

/// A window with its image at (x, -1) and this number.
Window window(double x, double sigma, double low, double high, Index name) {
  return {x, -1, sigma, low, high, name, no_index};
}

std::string shown(const std::vector<Window>& windows) {
  std::string text;
  for (const Window& w : windows)
    text += std::to_string(w.origin) + "[" + std::to_string(w.low) + " " + std::to_string(w.high) + "]";
  return text;
}

std::vector<Window> same_ends(std::initializer_list<Window> windows) { return windows; }

/// The same numbers and, to the last bit, the same ends.
testing::AssertionResult equal(const std::vector<Window>& seen, const std::vector<Window>& expected) {
  bool same = seen.size() == expected.size();
  for (std::size_t i = 0; same && i < seen.size(); ++i)
    same = seen[i].origin == expected[i].origin && seen[i].low == expected[i].low && seen[i].high == expected[i].high;
  if (same) return testing::AssertionSuccess();
  return testing::AssertionFailure() << shown(seen) << " instead of " << shown(expected);
}

class TrimmingCases : public testing::TestWithParam<Simd> {
 protected:
  void SetUp() override {
    if (!has_simd(GetParam())) GTEST_SKIP() << "this processor does not have the level";
  }

  static WindowList list_of(const std::vector<Window>& windows) {
    WindowList list;
    for (const Window& w : windows) list.push(w);
    return list;
  }
  /// By `trim`; without breaks.
  std::vector<Window> trimmed(const std::vector<Window>& windows) {
    const WindowList list = list_of(windows);
    std::vector<std::uint32_t> breaks;
    const std::size_t count = trimming_.trim(list.arrays(), list.size(), breaks);
    EXPECT_TRUE(breaks.empty());
    return listed(list.arrays(), count);
  }
  std::vector<Window> merged(const std::vector<Window>& a, const std::vector<Window>& b) {
    WindowList list = list_of(a);
    const WindowList other = list_of(b);
    trimming_.merge(list, other.span());
    return listed(list.arrays(), list.size());
  }

  Trimming trimming_{lanes(GetParam())};
};

TEST_P(TrimmingCases, OfTwoEqualWindowsOneIsKeptWhole) {
  const Window w = window(0, 0, -1, 2, 7);
  EXPECT_TRUE(equal(trimmed({w, w}), {w}));
  EXPECT_TRUE(equal(merged({w}, {w}), {w}));
}

TEST_P(TrimmingCases, OfManyEqualWindowsOneIsKeptWhole) {
  const Window w = window(0, 0, -1, 2, 7);
  for (std::size_t count = 1; count <= 12; ++count) EXPECT_TRUE(equal(trimmed(std::vector<Window>(count, w)), {w}));
}

TEST_P(TrimmingCases, WindowsThatTouchStayAsTheyAre) {
  const std::vector<Window> windows{window(0, 9, 0, 1, 0), window(0, 1, 1, 2, 1), window(3, 5, 2, 3, 2)};
  EXPECT_TRUE(equal(trimmed(windows), windows));
  EXPECT_TRUE(equal(merged({windows[0], windows[2]}, {windows[1]}), windows));
}

TEST_P(TrimmingCases, WindowsApartStayAsTheyAre) {
  const std::vector<Window> windows{window(0, 9, 0, 1, 0), window(0, 1, 1.5, 2, 1), window(3, 5, 4, 5, 2)};
  EXPECT_TRUE(equal(trimmed(windows), windows));
  EXPECT_TRUE(equal(merged({windows[0], windows[2]}, {windows[1]}), windows));
}

/// The images are mirrored at x = 1.
TEST_P(TrimmingCases, MirroredWindowsAreCutInTheMiddle) {
  const Window a = window(0, 0, 0, 2, 0), b = window(2, 0, 0, 2, 1);
  const std::vector<Window> expected{window(0, 0, 0, 1, 0), window(2, 0, 1, 2, 1)};
  EXPECT_TRUE(equal(trimmed({a, b}), expected));
  EXPECT_TRUE(equal(merged({a}, {b}), expected));
  EXPECT_TRUE(equal(merged({b}, {a}), expected));
}

/// Wherever it lies, and also if its end lies before its start by rounding.
TEST_P(TrimmingCases, AWindowOfNoWidthCostsItsNeighboursNothing) {
  const Window a = window(0, 0, 0, 1, 0), b = window(0, 0, 1, 2, 1);
  for (const double at : {-1.0, 0.0, 0.5, 1.0, 1.5, 2.0, 3.0})
    for (const double width : {0.0, -1e-16})
      for (const double sigma : {-9.0, 0.0, 9.0}) {
        const Window empty = window(1, sigma, at, at + width, 2);
        for (const auto& windows : {same_ends({empty, a, b}), same_ends({a, empty, b}), same_ends({a, b, empty}),
                                    same_ends({empty, empty, a, empty, empty, b})})
          ASSERT_TRUE(equal(trimmed(windows), {a, b})) << "at " << at << " width " << width << " sigma " << sigma;
        ASSERT_TRUE(equal(merged({a, b}, {empty}), {a, b})) << "at " << at;
        ASSERT_TRUE(equal(merged({empty}, {a, b}), {a, b})) << "at " << at;
      }
}

TEST_P(TrimmingCases, OfWindowsOfNoWidthNothingIsLeft) {
  const Window empty = window(1, 0, 1, 1, 0);
  for (std::size_t count = 1; count <= 9; ++count) EXPECT_TRUE(trimmed(std::vector<Window>(count, empty)).empty());
  EXPECT_TRUE(merged({empty}, {empty}).empty());
}

/// A wide window on the left of a narrow one inside it. At the end of the narrow one the wide one is nearer: the lemma
/// leaves nothing of the narrow one.
TEST_P(TrimmingCases, AWindowInsideAnotherThatLosesAtItsEndIsDropped) {
  const Window wide = window(0, 0, -3, 3, 0), narrow = window(0.5, 1, 1, 2, 1);
  EXPECT_TRUE(equal(trimmed({wide, narrow}), {wide}));
}

/// At its start the narrow one is nearer: no line of the wide one to the right of that is needed, also beyond the
/// narrow one.
TEST_P(TrimmingCases, AWindowInsideAnotherThatWinsAtItsStartEndsIt) {
  const Window wide = window(0, 2, -3, 3, 0), narrow = window(0.5, 0, 1, 2, 1);
  const std::vector<Window> expected{window(0, 2, -3, 1, 0), narrow};
  EXPECT_TRUE(equal(trimmed({wide, narrow}), expected));
}

/// Nothing is known about how they enter: the wide one stays on both sides.
TEST_P(TrimmingCases, MergedInsideAWindowANearerOneLeavesTwoPiecesOfIt) {
  const Window wide = window(0, 2, -3, 3, 0), narrow = window(0.5, 0, 1, 2, 1);
  const std::vector<Window> expected{window(0, 2, -3, 1, 0), narrow, window(0, 2, 2, 3, 0)};
  EXPECT_TRUE(equal(merged({wide}, {narrow}), expected));
  EXPECT_TRUE(equal(merged({narrow}, {wide}), expected));
}

TEST_P(TrimmingCases, MergedInsideAWindowAFartherOneLeavesItWhole) {
  const Window wide = window(0, 0, -3, 3, 0), narrow = window(0.5, 2, 1, 2, 1);
  EXPECT_TRUE(equal(merged({wide}, {narrow}), {wide}));
  EXPECT_TRUE(equal(merged({narrow}, {wide}), {wide}));
}

/// Distances tie exactly at x = 0 and nowhere else in the overlap, which begins or ends there.
TEST_P(TrimmingCases, ATieAtOneEndOfTheOverlapCutsThere) {
  const Window near_right = window(1, 0, 0, 2, 0), near_left = window(-1, 0, 0, 2, 1);
  EXPECT_TRUE(equal(merged({near_right}, {near_left}), {near_right}));
  EXPECT_TRUE(equal(merged({near_left}, {near_right}), {near_right}));
  const Window left = window(-1, 0, -2, 0, 0), right = window(1, 0, -2, 0, 1);
  EXPECT_TRUE(equal(merged({left}, {right}), {left}));
  EXPECT_TRUE(equal(merged({right}, {left}), {left}));
}

/// 13 = 2 + ... : images (0, -5) and (0, -9) at sigma 2 and 0 tie at x = 12 and -12, exactly; between, the first is
/// nearer.
TEST_P(TrimmingCases, TiesAtBothEndsOfTheOverlapLeaveTheOneThatIsNearerBetween) {
  const Window between{0, -5, 2, -12, 12, 0, no_index}, outside{0, -9, 0, -12, 12, 1, no_index};
  ASSERT_EQ(between.at(12), outside.at(12));
  EXPECT_TRUE(equal(merged({between}, {outside}), {between}));
  EXPECT_TRUE(equal(merged({outside}, {between}), {between}));
}

TEST_P(TrimmingCases, AWindowThatIsNearerInTheMiddleOnlyIsCutOnBothSides) {
  const Window between{0, -5, 2, -20, 20, 0, no_index}, outside{0, -9, 0, -20, 20, 1, no_index};
  const std::vector<Window> seen = merged({between}, {outside});
  ASSERT_EQ(shown(seen), "1[-20.000000 -12.000000]0[-12.000000 12.000000]1[12.000000 20.000000]");
  for (const double x : {seen[0].high, seen[1].high})  // equal distances of 15, which change by up to 12/13 with x
    EXPECT_LE(std::abs(between.at(x) - outside.at(x)), equal_share * 15);
}

/// A vertex on the ray of its parent: they tie on the ray, on either side of it each has its own.
TEST_P(TrimmingCases, ParentAndChildOnOneRayArePartedByTheRay) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    const double slope = random.uniform(-2, 2), child_y = -random.uniform(0.1, 1),
                 parent_y = child_y - power(random, 1e-6, 2);
    const Window parent{slope * parent_y, parent_y, 1, -5, 5, 0, no_index};  // the ray meets the half-edge at x = 0
    const Window child{slope * child_y, child_y, parent.to(slope * child_y, child_y), -5, 5, 1, no_index};
    Window parent_left = parent;
    parent_left.high = 0;
    // The part of the parent's lines to the left of the ray, and the child all over.
    const std::vector<Window> seen = trimmed({parent_left, child});
    ASSERT_EQ(seen.size(), 2U) << seed;
    ASSERT_EQ(seen[0].low, -5) << seed;
    ASSERT_EQ(seen[1].high, 5) << seed;
    ASSERT_EQ(seen[0].high, seen[1].low) << seed;
    const double x = seen[1].low;
    ASSERT_LE(std::abs(parent.at(x) - child.at(x)), equal_share * parent.at(x)) << seed << " at " << x;
  }
}

/// All lines of the left window meet the half-edge to the right of all lines of the right one, and each window is
/// farther than the other at its own end. The one that is nearer where their lines cross stays.
TEST_P(TrimmingCases, OfWindowsWhoseLinesCrossedTheNearerAtTheCrossingStays) {
  for (const double later : {-0.1, 0.0, 0.1}) {
    const Window left = window(0, 5 + later, 2.5, 3, 0), right = window(3, 5, 0, 0.5, 1);
    const std::vector<Window> expected{later > 0 ? right : left};
    EXPECT_TRUE(equal(trimmed({left, right}), expected)) << later;
  }
}

/// One image, in an order that only rounding can make.
const Window crossed_left = window(0, 0, 2.5, 3, 0), crossed_right = window(0, 0, 0, 0.5, 1);

TEST_P(TrimmingCases, WindowsThatCannotBePutInOrderAreBrokenApart) {
  const WindowList list = list_of({crossed_left, crossed_right});
  std::vector<std::uint32_t> breaks;
  EXPECT_EQ(trimming_.trim(list.arrays(), 2, breaks), 2U);
  EXPECT_EQ(breaks, std::vector<std::uint32_t>{1});
}

INSTANTIATE_TEST_SUITE_P(Levels, TrimmingCases, testing::ValuesIn(levels), level_name);

}  // namespace
}  // namespace geodrome::chen_han::test
