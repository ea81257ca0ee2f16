// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/claims.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "tests/plugins/common/window_pairs.hpp"
#include "tests/plugins/solver_schreiber/wavefronts.hpp"

namespace geodrome::schreiber::test {
namespace {

using chen_han::test::for_each_pair;

bool holds(const Interval& claim, double x) { return claim.low <= x && x <= claim.high; }
Interval claim_in(const Window& w) { return {w.low, w.high}; }

// ---- keep_left, keep_right

TEST(SchreiberKeep, TheNeighbourOfOneThatIsGoneHasWhatItWasNotFartherAt) {
  int cut_left = 0, cut_right = 0;
  for_each_pair([&](const Scene& scene, const Entered& first, const Entered& second, Random& random) {
    const Window &a = first.window, &b = second.window;
    if (!(std::max(a.low, b.low) < std::min(a.high, b.high))) return;
    Interval l = claim_in(a), r = claim_in(b);
    keep_left(generator_of(a), l, generator_of(b), claim_in(b));
    keep_right(generator_of(a), claim_in(a), generator_of(b), r);
    ASSERT_TRUE(l.low == a.low && l.high <= a.high && r.low >= b.low && r.high == b.high);
    cut_left += l.high<a.high, cut_right += r.low> b.low;
    for (const double x : sample_places(scene.length, {a.low, a.high, b.low, b.high, l.high, r.low}, random)) {
      const bool in_a = holds(claim_in(a), x), in_b = holds(claim_in(b), x);
      const double of_a = a.at(x), of_b = b.at(x), noise = scene.noise() * of_a;
      if (in_a && in_b && of_a < of_b - noise) {
        ASSERT_TRUE(holds(l, x) && !holds(r, x)) << x;
      }
      if (in_a && in_b && of_b < of_a - noise) {
        ASSERT_TRUE(holds(r, x) && !holds(l, x)) << x;
      }
      if (in_a && x < b.low) {
        ASSERT_TRUE(holds(l, x)) << x;
      }
      if (in_b && x > a.high) {
        ASSERT_TRUE(holds(r, x)) << x;
      }
    }
  });
  EXPECT_GT(cut_left, 1000);
  EXPECT_GT(cut_right, 1000);
}

TEST(SchreiberKeep, OneThatWasAsFarEverywhereKeepsAll) {
  const Generator g = generator_of({0.3, -1, 2, 0, 1, 0, 0});
  Generator farther = g;
  farther.sigma *= 1 + 4 * epsilon;
  Interval l{0, 0.8}, r{0.2, 1};
  keep_left(farther, l, g, {0.2, 1});
  keep_right(g, {0, 0.8}, farther, r);
  EXPECT_TRUE(l.high == 0.8 && r.low == 0.2);
}

TEST(SchreiberKeep, OneThatWasFartherEverywhereKeepsWhatTheOtherHadNot) {
  const Generator near = generator_of({0.3, -1, 2, 0, 1, 0, 0}), far = generator_of({0.3, -1, 2.1, 0, 1, 0, 0});
  Interval l{0, 0.8}, r{0.2, 1};
  keep_left(far, l, near, {0.2, 1});
  keep_right(near, {0, 0.8}, far, r);
  EXPECT_TRUE(l.high == 0.2 && r.low == 0.8);
}

// ---- right_has

/// Two windows whose lines cross the half-edge in order: the right one's are behind the left one's.
std::pair<Window, Window> neighbours(Random& random) {
  std::array<double, 4> ends;
  for (double& end : ends) end = random.uniform();
  std::sort(ends.begin(), ends.end());
  if (random.uniform() < 0.7) ends[2] = ends[1];
  Window a{random.uniform(-1, 2), -power(random, 1e-2, 2), 5, ends[0], ends[1], 0, 0}, b = a;
  b.x = random.uniform(-1, 2), b.y = -power(random, 1e-2, 2), b.low = ends[2], b.high = ends[3], b.origin = 1;
  b.sigma = a.at(a.high) - std::hypot(b.x - b.low, b.y);
  if (random.uniform() < 0.4) b.sigma += random.uniform(-0.3, 0.3);  // a jump: one ends without the other
  return {a, b};
}

enum class Ray { none, free, stopped, unclear };
/// Whether a window has a line to a point, and the other one is nearer before it anywhere, point by point.
Ray ray_to(const Window& w, const Window& other, double px, double py) {
  if (!has_line(w, px, py)) return Ray::none;
  constexpr int steps = 400;
  const double from = crossing(w, px, py), step = std::hypot(px - from, py) / steps;
  double behind = -infinity, before = crossing(other, from, 0);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, qx = from + t * (px - from), qy = t * py;
    behind = std::max(behind, w.to(qx, qy) - straight(other, qx, qy));
    const double place = crossing(other, qx, qy);
    if (std::min(before, place) < other.low && std::max(before, place) > other.high) return Ray::unclear;  // in a step
    before = place;
  }
  if (behind > 1e-9) return Ray::stopped;
  return behind == -infinity || behind < -2 * step ? Ray::free : Ray::unclear;
}

TEST(SchreiberRightHas, TellsWhoseAPointIsByRaysThatNobodyStops) {
  Random random(3);
  int left_stopped = 0, right_stopped = 0, both = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto [a, b] = neighbours(random);
    const double px = random.uniform(-1, 2), py = random.index(4) == 0 ? 0 : power(random, 1e-3, 5);
    const bool answer = right_has(generator_of(a), generator_of(b), px, py);
    const Ray left = ray_to(a, b, px, py), right = ray_to(b, a, px, py);
    const double of_left = straight(a, px, py), of_right = straight(b, px, py);
    if (left != Ray::none && right != Ray::none) {
      if (std::abs(of_left - of_right) < 1e-9) continue;
      ASSERT_EQ(answer, of_right < of_left) << i << ": both have a line";
      ++both;
    } else if (left == Ray::free || left == Ray::stopped) {
      ASSERT_EQ(answer, left == Ray::stopped) << i << ": only the left one has a line";
      left_stopped += left == Ray::stopped;
    } else if (right == Ray::free || right == Ray::stopped) {
      ASSERT_EQ(answer, right == Ray::free) << i << ": only the right one has a line";
      right_stopped += right == Ray::stopped;
    }
  }
  EXPECT_GT(left_stopped, 100);
  EXPECT_GT(right_stopped, 100);
  EXPECT_GT(both, 200);
}

TEST(SchreiberRightHas, APointInAGapOrOnTheLeftIsTheLeftOnes) {
  const Generator a = generator_of({0.2, -1, 0, 0, 0.4, 0, 0}), b = generator_of({0.8, -1, 0, 0.6, 1, 1, 0});
  EXPECT_FALSE(right_has(a, b, 0.5, 0));
  EXPECT_FALSE(right_has(a, b, -1, 0.5));
  EXPECT_TRUE(right_has(a, b, 2, 0.5));
}

TEST(SchreiberRightHas, OfTwoThatAreAsNearTheLeftOneHasIt) {
  const Generator g = generator_of({0.2, -1, 0, 0, 1, 0, 0});
  EXPECT_FALSE(right_has(g, g, 0.5, 0.5));
}

/// Behind both, on the wrong side of each: the one that is nearer where their outermost rays cross is the one to ask.
TEST(SchreiberRightHas, BehindTwoThatCrossedTheNearerWhereTheyDidCounts) {
  const Window left{-2, -1, 0, 0, 0.4, 0, 0}, right{3, -1, 0, 0.6, 1, 1, 0};
  for (const double later : {-0.1, 0.1}) {
    Generator a = generator_of(left);
    a.sigma += later;
    EXPECT_EQ(right_has(a, generator_of(right), 0.5, 2), later > 0);
  }
}

/// A front whose boundaries are in order is searched by halves: on a line above the half-edge all places behind the
/// first that is the right one's are.
TEST(SchreiberRightHas, ChangesOnceAlongTheHalfEdge) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const auto [a, b] = neighbours(random);
    const Generator left = generator_of(a), right = generator_of(b);
    bool before = false;
    for (int k = 0; k <= 200; ++k) {
      const bool now = right_has(left, right, k / 200.0, 0);
      ASSERT_TRUE(now || !before) << i << " at " << k;
      before = now;
    }
  }
}

}  // namespace
}  // namespace geodrome::schreiber::test
