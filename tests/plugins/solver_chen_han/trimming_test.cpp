// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/trimming.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/plugins/common/window_scenes.hpp"
#include "tests/plugins/solver_chen_han/levels.hpp"

namespace geodrome::chen_han::test {
namespace {

constexpr std::uint64_t scenes = 8000;

/// What trimming may drop, and what it may not. Random windows at one half-edge know only a part of the ways that a
/// surface has, so their lower envelope along the half-edge may well change: a line of R is rightly dropped at y if L
/// comes, on its way to some x beyond y, to a point q of R's line at least as short as R does, and L itself need not
/// have a line to y. What is always true is this:
///
///   1. The lemma: whatever line was dropped at y, another window has, on its own side of y or on that line, a place x
///      that is not farther from it (`reason_to_drop`). Then the two lines cross in the face below, and the dropped one
///      is not the shortest from there on.
///   2. For distances it follows: let the shortest way to y, straight or with a bend where it enters the face below, be
///      straight. Then it is kept (`expect_needed_kept`): else L's way to q, shortened to y, were shorter still.
class SceneTrimming : public testing::TestWithParam<Simd> {
 protected:
  void SetUp() override {
    if (!has_simd(GetParam())) GTEST_SKIP() << "this processor does not have the level";
  }

  struct Kept {
    std::vector<std::vector<Window>> runs;  ///< each in order
    std::vector<Window> all() const {
      std::vector<Window> windows;
      for (const auto& run : runs) windows.insert(windows.end(), run.begin(), run.end());
      return windows;
    }
  };

  /// Windows [begin, end) of a scene, trimmed.
  Kept trimmed(const Scene& scene, std::size_t begin, std::size_t end) {
    Kept kept;
    if (begin == end) return kept;
    WindowList list;
    for (std::size_t i = begin; i < end; ++i) list.push(scene.windows[i].window);
    std::vector<std::uint32_t> breaks;
    const std::size_t count = trimming_.trim(list.arrays(), list.size(), breaks);
    const std::vector<Window> windows = listed(list.arrays(), count);
    breaks.push_back(static_cast<std::uint32_t>(count));
    for (std::size_t k = 0, first = 0; k < breaks.size(); first = breaks[k++])
      kept.runs.push_back({windows.begin() + static_cast<std::ptrdiff_t>(first), windows.begin() + breaks[k]});
    return kept;
  }

  Trimming trimming_{lanes(GetParam())};
};

/// The least of |l x| - |r x|, over |r x|, for places x of a's interval from y on, before it (`before`) or behind it.
/// The difference is stationary where the line through the images meets the half-edge.
double least_gap(const Window& a, const Window& other, double y, bool before) {
  const double low = before ? a.low : std::max(a.low, y), high = before ? std::min(a.high, y) : a.high;
  double least = std::numeric_limits<double>::infinity();
  const double stationary = other.x + (a.x - other.x) * (other.y / (other.y - a.y));
  for (const double x : {low, high, stationary})
    if (low <= x && x <= high) least = std::min(least, (a.at(x) - other.at(x)) / other.at(x));
  return least;
}

/// Whether the dropped line to y crosses, before the half-edge, a line at an end of the other window, which is not
/// farther at the crossing: the lemma with that point for x.
bool is_stopped_before(const Window& other, const Window& dropped, double y, double noise) {
  const double vx = y - dropped.x, vy = -dropped.y, wx = dropped.x - other.x, wy = dropped.y - other.y;
  for (const double end : {other.low, other.high}) {
    const double ux = end - other.x, uy = -other.y, turn = ux * vy - uy * vx;
    const double along_other = (wx * vy - wy * vx) / turn, along = (wx * uy - wy * ux) / turn;
    if (!(0 <= along_other && along_other <= 1 && 0 <= along && along <= 1)) continue;
    const double qx = other.x + along_other * ux, qy = other.y + along_other * uy;
    if (other.to(qx, qy) <= dropped.to(qx, qy) * (1 + noise)) return true;
  }
  return false;
}

/// Statement 1.
bool reason_to_drop(const Scene& scene, const Window& dropped, double y) {
  for (const Entered& other : scene.windows) {
    if (other.window.origin == dropped.origin || !(other.window.low < other.window.high)) continue;
    const bool from_left = other.window.origin < dropped.origin;
    if (least_gap(other.window, dropped, y, !from_left) <= scene.noise()) return true;
    if (is_stopped_before(other.window, dropped, y, scene.noise())) return true;
  }
  return false;
}

std::vector<double> ends_of(const Scene& scene, const std::vector<Window>& kept) {
  std::vector<double> ends;
  for (const Window& w : kept) ends.push_back(w.low), ends.push_back(w.high);
  for (const Entered& e : scene.windows) ends.push_back(e.window.low), ends.push_back(e.window.high);
  return ends;
}

void expect_reasons(const Scene& scene, const std::vector<Window>& kept, Random& random) {
  for (const double y : sample_places(scene.length, ends_of(scene, kept), random))
    for (const Entered& entered : scene.windows) {
      if (!covers(entered.window, y)) continue;
      const bool has_it = std::any_of(
          kept.begin(), kept.end(), [&](const Window& w) { return w.origin == entered.window.origin && covers(w, y); });
      ASSERT_TRUE(has_it || reason_to_drop(scene, entered.window, y))
          << "window " << entered.window.origin << " at " << y;
    }
}

/// Statement 2; returns at how many places there was something to keep. Where the straight way is no shorter than a
/// bent one, but for rounding, either is right.
int expect_needed_kept(const Scene& scene, const std::vector<Window>& kept, Random& random) {
  std::vector<Window> given;
  for (const Entered& e : scene.windows) given.push_back(e.window);
  int needed = 0;
  for (const double y : sample_places(scene.length, ends_of(scene, kept), random)) {
    double bent = std::numeric_limits<double>::infinity();
    for (const Entered& e : scene.windows) bent = std::min(bent, e.bent(y));
    const double straight = nearest(given, y);
    if (!(straight * (1 + scene.noise()) < bent)) continue;
    if (!std::isfinite(straight)) continue;
    ++needed;
    EXPECT_LE(nearest(kept, y), straight * (1 + scene.noise())) << "at " << y << " of " << scene.length;
  }
  return needed;
}

/// Every piece is a part of the window it comes from, and is it in all else.
void expect_parts(const Scene& scene, const std::vector<Window>& kept) {
  for (const Window& w : kept) {
    const Window& whole = scene.windows.at(w.origin).window;
    ASSERT_TRUE(w.x == whole.x && w.y == whole.y && w.sigma == whole.sigma) << w.origin;
    ASSERT_GE(w.low, whole.low) << w.origin;
    ASSERT_LE(w.high, whole.high) << w.origin;
  }
}

TEST_P(SceneTrimming, LeavesRunsThatAreDisjointAndAscendingPartsOfWhatWasGiven) {
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 9);
    const Kept kept = trimmed(scene, 0, scene.windows.size());
    for (const auto& run : kept.runs) ASSERT_TRUE(in_order(run));
    expect_parts(scene, kept.all());
    if (HasFatalFailure()) return;
  }
}

TEST_P(SceneTrimming, CountsWhatItDrops) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 9);
    trimming_.reset();
    const std::size_t remaining = trimmed(scene, 0, scene.windows.size()).all().size();
    ASSERT_EQ(trimming_.dropped(), scene.windows.size() - remaining) << "seed " << seed;
  }
}

TEST_P(SceneTrimming, DropsNoLineWithoutTheLemma) {
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 9);
    expect_reasons(scene, trimmed(scene, 0, scene.windows.size()).all(), random);
    if (HasFatalFailure()) return;
  }
}

TEST_P(SceneTrimming, KeepsEveryLineThatIsShortest) {
  int needed = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 9);
    needed += expect_needed_kept(scene, trimmed(scene, 0, scene.windows.size()).all(), random);
    if (HasFailure()) return;
  }
  EXPECT_GT(needed, 20000);
}

/// Windows whose lines changed sides before the half-edge are settled where these cross, so that the scenes have none
/// that must be broken apart (TrimmingCases has).
TEST_P(SceneTrimming, TheScenesHaveEveryCase) {
  int nested = 0, empty = 0, crossed = 0, dropped = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 9);
    for (std::size_t i = 0; i + 1 < scene.windows.size(); ++i) {
      const Window &a = scene.windows[i].window, &b = scene.windows[i + 1].window;
      nested += (a.low < b.low && b.high < a.high) || (b.low < a.low && a.high < b.high);
      empty += !(a.low < a.high);
      crossed += a.low < a.high && b.low < b.high && b.high <= a.low;
    }
    const Kept kept = trimmed(scene, 0, scene.windows.size());
    dropped += kept.all().size() < scene.windows.size();
  }
  EXPECT_GT(nested, 100);
  EXPECT_GT(empty, 100);
  EXPECT_GT(crossed, 100);
  EXPECT_GT(dropped, 100);
}

INSTANTIATE_TEST_SUITE_P(Levels, SceneTrimming, testing::ValuesIn(levels), level_name);

}  // namespace
}  // namespace geodrome::chen_han::test
