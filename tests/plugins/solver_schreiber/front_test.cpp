// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/plugins/solver_schreiber/front_fixture.hpp"

namespace geodrome::schreiber::test {
namespace {

// ---- merge

void expect_envelope(const Front& front, const std::vector<Window>& windows, double length, Random& random) {
  std::vector<double> ends = places_of(front, length);
  for (const Window& w : windows) ends.push_back(w.low), ends.push_back(w.high);
  for (const double x : sample_places(length, ends, random)) {
    const double expected = truth(windows, x, 0).straight, seen = nearest_covering(front, x, 0);
    if (std::isfinite(expected)) {
      ASSERT_NEAR(seen, expected, 1e-14 * expected) << x << " of " << length;
    } else {
      ASSERT_EQ(seen, infinity) << "nobody has " << x;
    }
  }
}

TEST_F(SchreiberFront, MergedOneByOneIsTheLowerEnvelope) {
  std::size_t pieces = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double length = power(random, 0.1, 2), spread = random.index(4) == 0 ? 0 : power(random, 1e-3, 1);
    const auto windows = random_windows(random, 1 + seed % 8, length, spread, seed % 3 == 0);
    const Front front = envelope(editor_, pool_, windows, length);
    expect_in_order(front, length);
    expect_envelope(front, windows, length, random);
    expect_keys(front);
    if (HasFatalFailure()) return;
    pieces += front.size();
  }
  EXPECT_GT(pieces, 2500u);
}

TEST_F(SchreiberFront, MergedFromTwoIsTheLowerEnvelopeInEitherOrder) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto a = random_windows(random, 1 + seed % 5, 1, 0.2, false);
    const auto b = random_windows(random, 1 + seed % 7, 1, 0.2, false);
    Front first = envelope(editor_, pool_, a, 1), second = envelope(editor_, pool_, b, 1), other = second;
    const std::uint64_t before = editor_.counts().envelopes;
    editor_.merge(other, first, 1);
    editor_.merge(first, second, 1);
    EXPECT_EQ(editor_.counts().envelopes, before + 2);
    std::vector<Window> both = a;
    both.insert(both.end(), b.begin(), b.end());
    for (const Front& front : {first, other}) {
      expect_in_order(front, 1);
      expect_envelope(front, both, 1, random);
      expect_keys(front);
    }
    if (HasFatalFailure()) return;
  }
}

/// Two pieces of what lies behind, one on each side.
TEST_F(SchreiberFront, MergingPutsAnotherIntoTheMiddleOfOne) {
  const std::vector<Window> windows{{0.5, -2, 0, 0, 1, 0, 0}, {0.5, -0.1, 1.85, 0, 1, 1, 0}};
  const Front front = envelope(editor_, pool_, windows, 1);
  ASSERT_EQ(front.size(), 3u);
  EXPECT_TRUE(front[0].origin == 0 && front[1].origin == 1 && front[2].origin == 0);
  EXPECT_NEAR(front[1].low(1) + front[1].high(1), 1, 1e-14);
}

TEST_F(SchreiberFront, MergingALongOneIsTheLowerEnvelope) {
  Random random(1);
  const auto windows = many_windows(random, 1600, 2);
  const Front front = envelope(editor_, pool_, windows, 2);
  EXPECT_GT(front.size(), 100u);
  EXPECT_FALSE(front.is_flat());
  expect_in_order(front, 2);
  expect_envelope(front, windows, 2, random);
  expect_keys(front);
}

TEST_F(SchreiberFront, MergingNothingLeavesTheOther) {
  Front empty(pool_), front(pool_, generator_of({0, -1, 0, 0, 1, 7, 0}));
  editor_.merge(front, empty, 1);
  EXPECT_EQ(front.size(), 1u);
  editor_.merge(empty, front, 1);
  EXPECT_EQ(empty.size(), 1u);
  editor_.join(front, Front(pool_), 1);
  EXPECT_EQ(front.size(), 1u);
  Front other(pool_);
  editor_.join(other, front, 1);
  EXPECT_EQ(other.size(), 1u);
}

// ---- join

/// All that is shortest on a straight line, and not over an end of the half-edge, is known, and nobody has more than he
/// was given.
int expect_shortest(const Front& front, const Scene& scene, Random& random) {
  int needed = 0;
  front.for_each([&](const Generator& g) {
    const Window& given = scene.windows[g.origin].window;
    EXPECT_GE(g.low(scene.length), given.low - 1e-12 * scene.length);
    EXPECT_LE(g.high(scene.length), given.high + 1e-12 * scene.length);
  });
  for (const double x : sample_places(scene.length, places_of(front, scene.length), random)) {
    double expected = infinity, bend = infinity;
    for (const Entered& e : scene.windows) {
      expected = std::min(expected, straight(e.window, x, 0));
      bend = std::min({bend, e.bent(x), e.window.at(0) + x, e.window.at(scene.length) + scene.length - x});
    }
    if (!std::isfinite(expected) || !(expected * (1 + scene.noise()) < bend)) continue;
    ++needed;
    [&] {
      ASSERT_NEAR(nearest_covering(front, x, 0), expected, scene.noise() * expected) << x << " of " << scene.length;
    }();
    if (testing::Test::HasFatalFailure()) break;
  }
  return needed;
}

class SchreiberJoin : public SchreiberFront {
 protected:
  Front joined(const Scene& scene, std::size_t first, std::size_t end) {
    Front front(pool_);
    for (std::size_t i = first; i < end; ++i) {
      const Window& w = scene.windows[i].window;
      const Generator g = generator_of(w);
      if (w.low < w.high && !g.is_sliver()) editor_.join(front, Front(pool_, g), scene.length);
    }
    return front;
  }
};

TEST_F(SchreiberJoin, KeepsEveryLineThatIsShortest) {
  int needed = 0;
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 9);
    Front front = joined(scene, 0, scene.windows.size());
    expect_keys(front);
    needed += expect_shortest(front, scene, random);
    const std::size_t middle = random.index(scene.windows.size() + 1);
    front = joined(scene, 0, middle);
    editor_.join(front, joined(scene, middle, scene.windows.size()), scene.length);
    expect_keys(front);
    needed += expect_shortest(front, scene, random);
    most = std::max(most, front.size());
    if (HasFailure()) return;
  }
  EXPECT_GT(needed, 20000);
  EXPECT_GT(most, 5u);
  EXPECT_GT(editor_.counts().joins, 5000u);
}

TEST_F(SchreiberJoin, LeavesNothingThatOverlaps) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 9);
    const Front front = joined(scene, 0, scene.windows.size());
    for (std::size_t i = 0; i + 1 < front.size(); ++i)
      ASSERT_LE(front[i].high(scene.length), front[i + 1].low(scene.length) + 1e-9 * scene.length) << i;
  }
}

/// Two of one image that lie the other way round are in no order, and merged.
TEST_F(SchreiberJoin, MergesWhatIsTangled) {
  const Window w{0.3, -1, 2, 0.4, 0.8, 0, 0};
  Front left(pool_, generator_of(w));
  editor_.join(left, Front(pool_, generator_of({0.3, -1, 2, 0.2, 0.6, 1, 0})), 1);
  EXPECT_EQ(editor_.counts().envelopes, 1u);
  EXPECT_EQ(editor_.counts().joins, 0u);
  for (double x = 0.05; x < 1; x += 0.1)
    EXPECT_EQ(std::isfinite(nearest_covering(left, x, 0)), 0.2 < x && x < 0.8) << x;
}

TEST_F(SchreiberFront, TrimmedOfWhatIsTangledHasAllOfIt) {
  const Front front =
      editor_.front_of({generator_of({0.3, -1, 2, 0.4, 0.8, 0, 0}), generator_of({0.3, -1, 2, 0.2, 0.6, 1, 0})});
  const Front trimmed = editor_.trimmed(front, 1);
  expect_in_order(trimmed, 1);
  for (double x = 0.05; x < 1; x += 0.1)
    EXPECT_EQ(std::isfinite(nearest_covering(trimmed, x, 0)), 0.2 < x && x < 0.8) << x;
}

/// The wedges inside a front are wider than what exists: at the seam the outermost one, between the next one and the
/// other front, may have nothing.
TEST_F(SchreiberJoin, DropsWhatHasNothingBetweenTheNextAndTheOtherFront) {
  const std::vector<Window> windows{
      {0.3, -1, 2, 0, 1, 0, 0}, {0.9, -1, 2.113, 0.4, 1, 1, 0}, {3, -1, 0.557, 0.5, 1, 2, 0}};
  for (const bool mirrored : {false, true}) {
    Front two = editor_.front_of({generator_of(windows[0]), generator_of(windows[1])});
    Front one(pool_, generator_of(windows[2]));
    Front& left = mirrored ? one : two;
    Front& right = mirrored ? two : one;
    if (mirrored) one = editor_.mirrored(one, 1), two = editor_.mirrored(two, 1);
    editor_.join(left, right, 1);
    EXPECT_EQ(left.size(), 2u);
    expect_keys(left);
    for (double x = 0.05; x < 1; x += 0.1)
      EXPECT_NEAR(nearest_covering(left, mirrored ? 1 - x : x, 0), truth(windows, x, 0).straight, 1e-14) << x;
  }
}

// ---- fit

/// Of a half-edge that goes on beyond both ends of the one that counts.
TEST_F(SchreiberFront, FitsBetweenTheEndsOfTheHalfEdge) {
  int aimed = 0, removed = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto windows = random_windows(random, 1 + seed % 9, 3, 0.3, seed % 2 == 0);
    Front front = envelope(editor_, pool_, windows, 3);
    const std::size_t size = front.size();
    const FrontEditor::Before before{{1, 0, 1, 0}, 3};
    front.move(before.back.inverse());
    editor_.fit(front, 1, before);
    removed += front.size() < size;
    for (double place = -0.99; place < 2; place += 0.02) {
      const double expected = place < 0 || place > 1 ? infinity : truth(windows, place + 1, 0).straight;
      const double seen = nearest_covering(front, place, 0);
      ASSERT_TRUE(seen == expected || std::abs(seen - expected) < 1e-13 * seen) << seen << " at " << place;
    }
    if (front.empty()) continue;
    aimed += front.front().low(1) == 0;
    ASSERT_FALSE(front.front().passes_low(0) || front.back().passes_high(1));
    expect_keys(front, before.back);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(aimed, 500);
  EXPECT_GT(removed, 500);
}

// ---- remove

/// What it had of the half-edge nobody has then; its neighbours keep where they were nearer, and all beside it.
TEST_F(SchreiberFront, RemovingOneGivesNothingOfItToItsNeighbours) {
  int shared = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Scene scene = random_scene(random, 4);
    std::vector<Generator> all;  // as they entered the face below; on the half-edge they overlap
    for (const Entered& e : scene.windows)
      if (e.window.low < e.window.high) all.push_back(generator_of(e.window));
    if (all.empty()) continue;
    Front front = editor_.front_of(all);
    expect_keys(front);
    const std::size_t gone = random.index(all.size());
    editor_.remove(front, gone, {{}, scene.length});
    expect_keys(front);
    const std::vector<Generator> rest = generators_of(front);
    ASSERT_EQ(rest.size() + 1, all.size());
    const Window& other = scene.windows[all[gone].origin].window;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      ASSERT_EQ(rest[i].origin, all[i < gone ? i : i + 1].origin);
      const Window& own = scene.windows[rest[i].origin].window;
      ASSERT_TRUE(rest[i].x == own.x && rest[i].y == own.y && rest[i].sigma == own.sigma);
      const bool is_beside = i + 1 == gone || i == gone;
      const bool is_outer_now = (i == 0 && gone == 0) || (i + 1 == rest.size() && gone == rest.size());
      for (double x = 0.005 * scene.length; x < scene.length; x += 0.01 * scene.length) {
        const bool has_it = rest[i].low(scene.length) <= x && x <= rest[i].high(scene.length);
        if (x < own.low - 1e-9 || x > own.high + 1e-9) {
          ASSERT_FALSE(has_it) << i << " grew to " << x;
        }
        if (x < own.low + 1e-9 || x > own.high - 1e-9) continue;
        if (i + 1 == gone ? x > other.high : i == gone && x < other.low) continue;  // behind it
        const bool is_shared = is_beside && other.low <= x && x <= other.high;
        const double lead = other.at(x) - own.at(x);
        shared += is_shared;
        if (is_shared ? std::abs(lead) > 1e-9 : !is_outer_now) {
          ASSERT_EQ(has_it, !is_shared || lead > 0) << i << " at " << x;
        }
      }
    }
  }
  EXPECT_GT(shared, 10000);
}

TEST_F(SchreiberFront, RemovingAnOuterOneBoundsTheNextByItsRay) {
  Front front = editor_.front_of({generator_of({0, -1, 3, 0.2, 0.5, 0, 0}), generator_of({0.5, -1, 0, 0.1, 0.9, 1, 0}),
                                  generator_of({1, -1, 3, 0.6, 0.8, 2, 0})});
  editor_.remove(front, 0, {{}, 1});
  editor_.remove(front, 1, {{}, 1});
  ASSERT_EQ(front.size(), 1u);
  EXPECT_NEAR(front[0].low(1), 0.2, 1e-15);
  EXPECT_NEAR(front[0].high(1), 0.8, 1e-15);
  EXPECT_EQ(editor_.counts().events, 2u);
  EXPECT_EQ(front[0].key, infinity);
}

// ---- mirrored

TEST_F(SchreiberFront, MirroredTwiceIsTheSame) {
  for (const std::size_t count : {1, 6, 200}) {
    Random random(count);
    const double length = 0.75;
    const Front front = envelope(editor_, pool_, many_windows(random, count, length), length);
    const auto first = generators_of(front), once = generators_of(editor_.mirrored(front, length)),
               twice = generators_of(editor_.mirrored(editor_.mirrored(front, length), length));
    ASSERT_EQ(once.size(), first.size());
    ASSERT_EQ(twice.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      const Generator &a = first[i], &b = twice[i], &m = once[first.size() - 1 - i];
      EXPECT_NEAR(a.x, b.x, 2 * epsilon);
      EXPECT_TRUE(a.y == b.y && a.sigma == b.sigma && a.key == b.key && a.origin == b.origin);
      EXPECT_TRUE(a.low_x == b.low_x && a.low_y == b.low_y && a.high_x == b.high_x && a.high_y == b.high_y);
      EXPECT_TRUE(m.key == a.key && m.origin == a.origin);
      EXPECT_NEAR(m.low(length), length - a.high(length), 1e-14);
    }
    expect_keys(editor_.mirrored(front, length));
  }
}

}  // namespace
}  // namespace geodrome::schreiber::test
