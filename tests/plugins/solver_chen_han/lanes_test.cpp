// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "tests/plugins/common/window_scenes.hpp"
#include "tests/plugins/solver_chen_han/levels.hpp"
#include "tests/plugins/solvers/fixture.hpp"

namespace geodrome::chen_han::test {
namespace {

constexpr std::size_t most = 20, room = most + 2 * most_lanes;
constexpr Clip no_clip{0, static_cast<int>(room)};

/// Up to `most` windows with room for lanes behind them.
class Windows {
 public:
  WindowArrays arrays() const { return WindowArrays(memory_.get(), room); }

 private:
  std::unique_ptr<double[]> memory_{std::make_unique<double[]>(room * WindowArrays::doubles_per_window)};
};

/// Anything: images on the half-edge, the same image twice, windows of no width, any order.
Windows random_windows(std::size_t count, Random& random) {
  Windows windows;
  Window w{};
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || random.uniform() < 0.8) {
      w.x = random.uniform(-2, 3), w.y = random.uniform() < 0.1 ? 0 : -power(random, 1e-15, 2);
      w.sigma = random.uniform() < 0.3 ? 1 : random.uniform(0, 2);
    }
    w.low = random.uniform(), w.high = random.uniform() < 0.1 ? w.low : random.uniform(w.low, 1);
    windows.arrays().set(i, w);
  }
  return windows;
}

/// From the half-edge (0, 0) - (length, 0) to the edge from its start (`left`) or its end, which makes an angle with
/// it.
Turn turn_to(bool left, double length, long double angle, double limit) {
  const auto cosine = static_cast<double>(std::cos(angle)), sine = static_cast<double>(std::sin(angle));
  return left ? Turn{0, cosine, sine, 0, limit, limit} : Turn{length, cosine, -sine, limit, limit, 0};
}

Turn random_turn(Random& random) {
  return turn_to(random.uniform() < 0.5, 1, random.uniform(1e-3, std::numbers::pi - 1e-3), power(random, 1e-2, 3));
}

bool same_bytes(const Windows& a, const Windows& b, std::size_t count) {
  for (const auto member :
       {&WindowArrays::x, &WindowArrays::y, &WindowArrays::sigma, &WindowArrays::low, &WindowArrays::high})
    if (std::memcmp((a.arrays().*member)(), (b.arrays().*member)(), count * sizeof(double)) != 0) return false;
  return true;
}

class WiderLanes : public testing::TestWithParam<Simd> {
 protected:
  void SetUp() override {
    if (!has_simd(GetParam())) GTEST_SKIP() << "this processor does not have the level";
  }
  const Lanes& baseline_ = lanes(Simd::baseline);
};

constexpr std::uint64_t seeds = 300;

TEST_P(WiderLanes, CarryToTheSameBytes) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (std::size_t count = 1; count <= most; ++count) {
      Random random(seed * 100 + count);
      const Windows in = random_windows(count, random), a, b;
      const Turn turn = random_turn(random);
      const Clip clip{static_cast<int>(random.index(count + 1)), static_cast<int>(random.index(count + 1))};
      baseline_.carry(in.arrays(), count, turn, clip, a.arrays());
      lanes(GetParam()).carry(in.arrays(), count, turn, clip, b.arrays());
      ASSERT_TRUE(same_bytes(a, b, count)) << seed << ' ' << count;
    }
}

TEST_P(WiderLanes, CutAtTheSameBytes) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (std::size_t count = 1; count <= most; ++count) {
      Random random(seed * 100 + count), again(seed * 100 + count);
      const Windows a = random_windows(count, random), b = random_windows(count, again);
      const Trimmed by_a = baseline_.cut(a.arrays(), count), by_b = lanes(GetParam()).cut(b.arrays(), count);
      ASSERT_EQ(by_a.unsure, by_b.unsure) << seed << ' ' << count;
      ASSERT_EQ(by_a.empty, by_b.empty) << seed << ' ' << count;
      ASSERT_TRUE(same_bytes(a, b, count)) << seed << ' ' << count;
    }
}

TEST_P(WiderLanes, PartListsInTheSamePlaces) {
  int in_order = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (std::size_t count = 1; count <= most; ++count) {
      Random random(seed * 100 + count);
      const Windows in = random_windows(count, random);
      const double x = random.uniform(), y = random.uniform();
      const Parting a = baseline_.part(in.arrays(), count, x, y), b = lanes(GetParam()).part(in.arrays(), count, x, y);
      ASSERT_EQ(a.in_order, b.in_order) << seed << ' ' << count;
      ASSERT_TRUE(!a.in_order || a.right_begin == b.right_begin) << seed << ' ' << count;
      ASSERT_TRUE(!a.in_order || a.left_end == b.left_end) << seed << ' ' << count;
      in_order += a.in_order;
    }
  EXPECT_GT(in_order, 20);
}

INSTANTIATE_TEST_SUITE_P(Levels, WiderLanes, testing::Values(Simd::avx2, Simd::avx512), level_name);

/// An edge by its start, the unit vector along it and the one to its left.
struct Frame {
  long double x, y, ux, uy;
  long double along(long double px, long double py) const { return (px - x) * ux + (py - y) * uy; }
  long double above(long double px, long double py) const { return (py - y) * ux - (px - x) * uy; }
};

/// The frame on the other side of the edge of a face that has this angle at the start or the end of its half-edge.
Frame frame_of(bool left, double length, long double angle, double limit) {
  if (left) return {0, 0, std::cos(angle), std::sin(angle)};
  return {length - limit * std::cos(angle), limit * std::sin(angle), std::cos(angle), -std::sin(angle)};
}

/// An image that is above the new edge by more than this share of its distance looks at it from behind; one that is
/// less above it is on it, but for rounding. Twice the solver's own limit, so that roundings decide nothing here.
constexpr double behind_share = 2e-13;

/// Images and ends in the new frame are sums of products of a size of at most `scale`: each has 4 roundings. Where the
/// line meets the new edge, they count by the derivatives of qx + (qx - x) down / climb.
void expect_met(const Frame& frame, const Window& w, double end, double limit, double away, double seen) {
  constexpr long double eps = std::numeric_limits<double>::epsilon();
  const long double scale = std::abs(w.x) + std::abs(w.y) + 1 + limit, error = 4 * eps * scale;
  const long double x = frame.along(w.x, w.y), y = frame.above(w.x, w.y);
  const long double qx = frame.along(end, 0), down = -frame.above(end, 0), climb = -down - y;
  if (std::abs(climb) <= 8 * error) return;  // along the edge, but for rounding: anywhere on it
  if (climb < 0) {
    const long double expected = std::abs(down) <= error ? seen : down > 0 ? away : qx;
    ASSERT_NEAR(seen, std::clamp<long double>(expected, 0, limit), error);
    return;
  }
  const long double met = qx + (qx - x) * down / climb, reach = std::abs(qx - x);
  const long double slack =
      2 * error * (1 + (std::abs(down) + reach) / climb + reach * std::abs(down) / (climb * climb));
  ASSERT_NEAR(seen, std::clamp<long double>(met, 0, limit), slack) << "climb " << climb;
}

/// Against trigonometry in long double.
TEST(Carry, GoesWhereTheStraightLineDoes) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    const bool left = random.uniform() < 0.5;
    const double limit = power(random, 1e-2, 3);
    const long double angle = random.uniform() < 0.2 ? power(random, 1e-9, 1e-2) : random.uniform(1e-2, 3.13);
    const Turn turn = turn_to(left, 1, angle, limit);
    const Frame frame = frame_of(left, 1, angle, limit);
    const Windows in = random_windows(most, random), out;
    lanes(Simd::baseline).carry(in.arrays(), most, turn, no_clip, out.arrays());
    for (std::size_t i = 0; i < most; ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " window " << i);
      const Window w = in.arrays().get(i), seen = out.arrays().get(i);
      const double error = 4 * std::numeric_limits<double>::epsilon() * (std::abs(w.x) + std::abs(w.y) + 1 + limit);
      ASSERT_NEAR(seen.x, frame.along(w.x, w.y), error);
      ASSERT_NEAR(seen.y, std::min(0.0L, frame.above(w.x, w.y)), error);
      const long double away = std::abs(w.x - turn.pivot) + std::abs(w.y), above = frame.above(w.x, w.y);
      if (above > 0) {
        ASSERT_FALSE(above > behind_share * away && seen.low < seen.high) << "seen from behind";
        continue;
      }
      expect_met(frame, w, w.low, limit, turn.away, seen.low);
      expect_met(frame, w, w.high, limit, turn.away, seen.high);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Carry, LeavesTheImageBelowAndTheEndsOnTheEdge) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    const Turn turn = random_turn(random);
    const Windows in = random_windows(most, random), out;
    lanes(Simd::baseline).carry(in.arrays(), most, turn, no_clip, out.arrays());
    for (std::size_t i = 0; i < most; ++i) {
      const Window w = out.arrays().get(i);
      ASSERT_LE(w.y, 0);
      ASSERT_TRUE(w.low >= 0 && w.low <= turn.limit && w.high >= 0 && w.high <= turn.limit) << seed << ' ' << i;
    }
  }
}

TEST(Carry, ClipsTheFirstAtTheStartAndTheLastAtTheEnd) {
  Random random(5);
  const Turn turn = random_turn(random);
  const Windows in = random_windows(most, random), plain, clipped;
  lanes(Simd::baseline).carry(in.arrays(), most, turn, no_clip, plain.arrays());
  lanes(Simd::baseline).carry(in.arrays(), most, turn, {3, 11}, clipped.arrays());
  for (std::size_t i = 0; i < most; ++i) {
    EXPECT_EQ(clipped.arrays().low()[i], i < 3 ? 0 : plain.arrays().low()[i]) << i;
    EXPECT_EQ(clipped.arrays().high()[i], i >= 11 ? turn.limit : plain.arrays().high()[i]) << i;
  }
}

/// What a cut makes of a pair: nothing where it is unsure or nothing overlaps; one place where both are equally far;
/// or the one that is nearer where the overlap ends, on the side of the other, takes all of it.
void expect_right_cut(const Window& a, const Window& b, const Window& cut_a, const Window& cut_b, bool unsure) {
  ASSERT_TRUE(a.low == cut_a.low && b.high == cut_b.high);
  const bool is_cut = cut_a.high != a.high || cut_b.low != b.low;
  const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
  if (unsure || !(low < high)) {
    ASSERT_FALSE(is_cut);
    return;
  }
  const auto gap = [&](double x) { return a.at(x) - b.at(x); };
  const bool equal = cut_a.high == cut_b.low && std::abs(gap(cut_b.low)) <= equal_share * a.at(cut_b.low);
  const bool first_wins = cut_a.high == a.high && cut_b.low == high && gap(high) < 0;
  const bool second_wins = cut_b.low == b.low && cut_a.high == low && gap(low) > 0;
  ASSERT_TRUE(equal || first_wins || second_wins) << cut_a.high << ' ' << cut_b.low;
}

TEST(Cut, IsWhereBothAreEquallyFarOrTheNearerOneKeepsAll) {
  int cut = 0, unsure = 0;
  for (std::uint64_t seed = 1; seed <= 30000; ++seed) {
    Random random(seed);
    const Windows two = random_windows(2, random);
    const Window a = two.arrays().get(0), b = two.arrays().get(1);
    const Trimmed told = lanes(Simd::baseline).cut(two.arrays(), 2);
    expect_right_cut(a, b, two.arrays().get(0), two.arrays().get(1), told.unsure);
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
    ASSERT_EQ(told.empty, two.arrays().empty(0) || two.arrays().empty(1)) << seed;
    unsure += told.unsure;
    cut += two.arrays().high()[0] != a.high || two.arrays().low()[1] != b.low;
  }
  EXPECT_GT(cut, 5000);
  EXPECT_GT(unsure, 100);
}

TEST(Cut, LeavesNoNeighboursThatOverlapUnlessItTellsSo) {
  int with = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    const std::size_t count = 1 + random.index(6);
    const Windows in = random_windows(count, random);
    const WindowArrays& w = in.arrays();
    const Trimmed told = lanes(Simd::baseline).cut(w, count);
    for (std::size_t i = 0; !told.unsure && i + 1 < count; ++i)
      ASSERT_TRUE(w.high()[i] <= w.low()[i + 1] || w.empty(i) || w.empty(i + 1)) << seed;
    (told.unsure ? with : without)++;
  }
  EXPECT_GT(std::min(with, without), 100);
}

/// Ordered windows as a surface has them, the left one nearer where the overlap begins, the right one where it ends.
TEST(Cut, OfWindowsThatChangePlacesSeldomNeedsMoreThanTheFormula) {
  int pairs = 0, unknown = 0;
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    Random random(seed);
    const Scene scene = random_scene(random, 6);
    for (std::size_t i = 0; i + 1 < scene.windows.size(); ++i) {
      const Window &a = scene.windows[i].window, &b = scene.windows[i + 1].window;
      const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
      if (b.low < a.low && b.high < a.high) continue;  // on the other side of its neighbour
      if (!(low < high) || a.at(low) >= b.at(low) || b.at(high) >= a.at(high)) continue;
      const Windows two;
      two.arrays().set(0, a), two.arrays().set(1, b);
      unknown += lanes(Simd::baseline).cut(two.arrays(), 2).unsure;
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 300);
  EXPECT_LT(unknown, pairs / 100);
}

TEST(Part, CountsTheWindowsOfEachSideAndTellsWhetherTheyAreFirstAndLast) {
  int in_order = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Random random(seed);
    const std::size_t count = 1 + random.index(6);
    const Windows in = random_windows(count, random);
    const double x = random.uniform(), y = random.uniform(0.1, 1);
    std::vector<bool> left, right;
    for (std::size_t i = 0; i < count; ++i) {
      const Window w = in.arrays().get(i);
      left.push_back(side_of_line(w.x, w.y, w.low, x, y) < 0),
          right.push_back(side_of_line(w.x, w.y, w.high, x, y) > 0);
    }
    const Parting parting = lanes(Simd::baseline).part(in.arrays(), count, x, y);
    const bool expected = std::is_sorted(left.rbegin(), left.rend()) && std::is_sorted(right.begin(), right.end());
    ASSERT_EQ(parting.in_order, expected) << seed;
    in_order += expected;
    if (!expected) continue;
    ASSERT_EQ(parting.left_end, std::count(left.begin(), left.end(), true)) << seed;
    ASSERT_EQ(count - parting.right_begin, std::count(right.begin(), right.end(), true)) << seed;
  }
  EXPECT_GT(in_order, 500);
  EXPECT_LT(in_order, 1900);
}

/// Bytes, not values: not even the sign of a zero may differ.
TEST(SolverChenHan, GivesTheSameBytesAtEverySimdLevel) {
  using geodrome::test::load_solver, geodrome::test::random_meshes, geodrome::test::from_vertex;
  const auto narrow = load_solver("chen_han:simd=baseline");
  int compared = 0;
  for (const Simd level : {Simd::avx2, Simd::avx512}) {
    if (!has_simd(level)) continue;
    const auto wide = load_solver("chen_han:simd=" + name_of(level));
    for (const std::uint64_t seed : {1, 2, 3})
      for (const MeshPtr& mesh : random_meshes(seed)) {
        const std::vector<double> a = from_vertex(narrow, mesh, 0), b = from_vertex(wide, mesh, 0);
        ASSERT_EQ(a.size(), b.size());
        EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0) << seed;
        ++compared;
      }
  }
  if (compared == 0) GTEST_SKIP() << "this processor has the baseline only";
}

}  // namespace
}  // namespace geodrome::chen_han::test
