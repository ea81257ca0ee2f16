// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/claimant.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plugins/solver_schreiber/kept_fronts.hpp"
#include "tests/plugins/solver_schreiber/wavefronts.hpp"

namespace geodrome::schreiber::test {
namespace {

constexpr double at_the_point = 1e-11;  // more than rounding

class SchreiberOwner : public testing::Test {
 protected:
  /// The owner of points in the face above, of all that are shortest on a straight line, is as near as the nearest of
  /// all windows; whether only those that can have died up to `least` behind the point are looked at, or more.
  void expect_owners(const Front& front, const std::vector<Window>& windows, double length, int points, double least,
                     Random& random) {
    for (int i = 0; i < points; ++i) {
      const double px = length * random.uniform(-0.5, 1.5);
      const double py = random.index(4) == 0 ? 0 : length * power(random, 1e-4, 10);
      const Truth t = truth(windows, px, py);
      if (!t.is_clear() || (py == 0 && (px < 0 || px > length))) continue;
      for (const double until : {t.straight + least, t.straight + least + 0.1 * length, infinity}) {
        const Generator g = owner_at(front, px, py, until);
        ASSERT_NEAR(g.to(px, py), t.straight, 1e-13 * t.straight)
            << g.origin << " has " << px << " " << py << " until " << until;
      }
      died_ += front.size() > 1 && front.least_key() < t.straight;
      ++asked_;
    }
  }

  FrontPool pool_;
  FrontEditor editor_{pool_};
  int asked_ = 0, died_ = 0;
};

TEST_F(SchreiberOwner, OfAShortFrontIsTheNearestOfAll) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double length = power(random, 0.1, 2);
    const auto windows = random_windows(random, 1 + seed % 20, length, power(random, 1e-3, 1), seed % 2 == 0);
    const Front front = envelope(editor_, pool_, windows, length);
    EXPECT_TRUE(front.is_flat());
    expect_owners(front, windows, length, 20, length, random);
    if (HasFailure()) return;
  }
  EXPECT_GT(asked_, 10000);
  EXPECT_GT(died_, 1000);
}

TEST_F(SchreiberOwner, OfALongFrontIsTheNearestOfAll) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto windows = many_windows(random, 400 * (1 + seed), 1);
    const Front front = envelope(editor_, pool_, windows, 1);
    EXPECT_FALSE(front.is_flat());
    longest = std::max(longest, front.size());
    expect_owners(front, windows, 1, 2000, at_the_point, random);
    if (HasFailure()) return;
  }
  EXPECT_GT(asked_, 5000);
  EXPECT_GT(died_, 4000);
  EXPECT_GT(longest, 100u);
}

/// Where one ends and the next is farther, as propagation asks: up to what the face can add.
TEST_F(SchreiberOwner, OfALongFrontWithGapsIsTheNearestOfAll) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    auto windows = many_windows(random, 1200, 1);
    for (Window& w : windows) {
      w.low = std::max(0.0, w.x - 0.01 * random.uniform()), w.high = std::min(1.0, w.x + 0.01 * random.uniform());
    }
    std::erase_if(windows, [](const Window& w) { return 0.3 < w.x && w.x < 0.4; });
    const Front front = envelope(editor_, pool_, windows, 1);
    EXPECT_FALSE(front.is_flat());
    expect_owners(front, windows, 1, 2000, 1, random);
    if (HasFailure()) return;
  }
  EXPECT_GT(asked_, 1000);
}

/// Moved, a long front holds its generators in other frames.
TEST_F(SchreiberOwner, OfALongFrontIsTheSameInAnotherFrame) {
  Random random(1);
  const auto windows = many_windows(random, 1200, 1);
  const Front front = envelope(editor_, pool_, windows, 1);
  Front moved = front;
  const Motion motion{std::cos(0.3), std::sin(0.3), 2, 1};
  moved.move(motion);
  for (int i = 0; i < 2000; ++i) {
    const double px = random.uniform(), py = power(random, 1e-4, 10);
    const Truth t = truth(windows, px, py);
    if (!t.is_clear()) continue;
    const auto [x, y] = motion(px, py);
    ASSERT_NEAR(owner_at(moved, x, y, t.straight * (1 + 1e-12)).to(x, y), t.straight, 1e-13 * t.straight) << i;
  }
}

TEST_F(SchreiberOwner, OfALoneGeneratorIsItWherever) {
  const Front front(pool_, generator_of({0, -1, 0, 0.4, 0.6, 0, 0}));
  for (const auto& [x, y] : {std::pair(0.5, 0.0), std::pair(0.0, 0.0), std::pair(9.0, 1.0), std::pair(-9.0, 1.0)})
    EXPECT_EQ(owner_of(front, x, y, infinity), 0u);
}

// ---- way_through

/// The shortest way over a place of what a generator has, found by thirds.
double shortest_over(const Window& w, double px, double py) {
  double low = w.low, high = w.high;
  const auto way = [&](double x) { return w.at(x) + std::hypot(px - x, py); };
  for (int step = 0; step < 200; ++step) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (way(a) < way(b) ? high : low) = way(a) < way(b) ? b : a;
  }
  return std::min({way(low), way(w.low), way(w.high)});
}

TEST(SchreiberWayThrough, IsTheShortestOverWhatTheGeneratorHas) {
  Random random(2);
  int is_straight = 0, is_bent = 0;
  for (int i = 0; i < 20000; ++i) {
    const double length = power(random, 0.1, 2);
    const Window w = random_windows(random, 1, length, 0, false)[0];
    const double px = length * random.uniform(-0.5, 1.5),
                 py = random.index(5) == 0 ? 0 : length * power(random, 1e-3, 3);
    const Crossing crossing = way_through(generator_of(w), length, px, py, infinity);
    const double expected = shortest_over(w, px, py);
    ASSERT_NEAR(crossing.distance, expected, 1e-14 * expected) << i;
    ASSERT_GE(crossing.place, w.low - 1e-12 * length) << i;
    ASSERT_LE(crossing.place, w.high + 1e-12 * length) << i;
    ASSERT_NEAR(w.at(crossing.place) + std::hypot(px - crossing.place, py), expected, 1e-13 * expected) << i;
    has_line(w, px, py) ? ++is_straight : ++is_bent;
    // If no image can be nearer than the best, it need not be found out.
    const double best = expected * random.uniform(0.5, 1.5);
    const double seen = way_through(generator_of(w), length, px, py, best).distance;
    ASSERT_TRUE(seen == crossing.distance || (seen >= best && expected >= best)) << i;
  }
  EXPECT_GT(is_straight, 2000);
  EXPECT_GT(is_bent, 2000);
}

/// An image of the half-edge itself, as in faces without area.
TEST(SchreiberWayThrough, AnImageOnTheHalfEdgeCrossesThere) {
  Generator g{0.5, 0, 3, -1, 0, 1, 0, 0, 0};
  for (const double y : {0.0, 0.25}) {
    const Crossing crossing = way_through(g, 1, 0.75, y, infinity);
    EXPECT_DOUBLE_EQ(crossing.distance, 3 + std::hypot(0.25, y));
    EXPECT_DOUBLE_EQ(crossing.place, y > 0 ? 0.5 : 0.75);
  }
}

// ---- KeptFronts

std::vector<std::pair<Index, Index>> visited(const KeptFronts& kept, Index half_edge, Index end) {
  std::vector<std::pair<Index, Index>> seen;  // origin, number
  kept.for_each(half_edge, end, [&](const Front& front, Index number) { seen.push_back({front[0].origin, number}); });
  return seen;
}

TEST(SchreiberKeptFronts, AreNumberedAsTheyCameAndFoundByHalfEdgeTheLastFirst) {
  FrontPool pool;
  KeptFronts kept;
  EXPECT_TRUE(visited(kept, 3, no_index).empty()) << "nothing was ever kept";
  for (int round = 0; round < 2; ++round) {
    kept.prepare(7);
    for (Index i = 0; i < 30; ++i) {
      kept.keep(i * i % 7, Front(pool, generator_of({0, -1, 0, 0, 1, 100 + i, 0})));
      EXPECT_EQ(kept.last(), i);
    }
    for (Index half_edge = 0; half_edge < 7; ++half_edge)
      for (const Index end : {Index{0}, Index{1}, Index{15}, Index{29}, no_index}) {
        std::vector<std::pair<Index, Index>> expected;
        for (Index i = std::min<Index>(end, 30); i-- > 0;)
          if (i * i % 7 == half_edge) expected.push_back({100 + i, i});
        EXPECT_EQ(visited(kept, half_edge, end), expected) << half_edge << " below " << end;
      }
    kept.reset();
    EXPECT_EQ(kept.last(), no_index);
    for (Index half_edge = 0; half_edge < 7; ++half_edge) EXPECT_TRUE(visited(kept, half_edge, no_index).empty());
  }
  EXPECT_EQ(pool.bytes_in_use(), 0u);
}

TEST(SchreiberKeptFronts, StayAsTheyWereWhateverIsDoneWithTheirCopies) {
  FrontPool pool;
  FrontEditor editor(pool);
  Random random(3);
  Front front = envelope(editor, pool, many_windows(random, 800, 1), 1);
  KeptFronts kept;
  kept.prepare(1);
  kept.keep(0, front);
  const Generator before = front[50];
  front.move({0, 1, 2, 3});
  editor.remove(front, 50, {{}, 1});
  kept.for_each(0, no_index, [&](const Front& same, Index) {
    EXPECT_EQ(same.size(), front.size() + 1);
    EXPECT_TRUE(same[50].x == before.x && same[50].high_x == before.high_x && same[50].key == before.key);
  });
}

}  // namespace
}  // namespace geodrome::schreiber::test
