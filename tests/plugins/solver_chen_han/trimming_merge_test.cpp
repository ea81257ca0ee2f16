// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/solver_chen_han/trimming.hpp"
#include "tests/plugins/solver_chen_han/window_scenes.hpp"

/// What does not ask how windows enter: merging, and the place where two are equally far.
namespace geodrome::chen_han::test {
namespace {

constexpr double length = 1.5;

/// An image at about `distance` from the half-edge's middle, whose own height is anything, nothing too.
Window random_window(double distance, double spread, Random& random) {
  const double y = random.uniform() < 0.1 ? 0 : -power(random, 1e-14, 2);
  Window w{random.uniform(-1, length + 1), y, 0, 0, length, 0, no_index};
  w.sigma = std::max(0.0, distance + spread * random.uniform() - w.at(length / 2));
  return w;
}

/// Up to `most` disjoint ascending windows; some touch.
std::vector<Window> random_list(std::size_t most, double spread, Index first_name, Random& random) {
  std::vector<double> ends(2 * random.index(most + 1));
  for (double& end : ends) end = random.uniform() < 0.1 ? length : random.uniform(0, length);
  std::sort(ends.begin(), ends.end());
  std::vector<Window> list;
  for (std::size_t i = 0; i + 1 < ends.size(); i += random.index(2) + 1) {
    Window w = random_window(3, spread, random);
    w.low = ends[i], w.high = ends[i + 1];
    w.origin = first_name + static_cast<Index>(list.size());
    list.push_back(w);
  }
  return list;
}

/// Two lists; windows of the second may have the image of one of the first, or its ends.
struct Lists {
  std::vector<Window> first, second;

  explicit Lists(std::uint64_t seed) {
    Random random(seed);
    const double spread = seed % 3 == 0 ? 0 : power(random, 1e-6, 3);
    first = random_list(1 + seed % 12, spread, 0, random);
    second = random_list(1 + seed % 7, spread, static_cast<Index>(first.size()), random);
    if (first.empty()) return;
    for (Window& w : second) {
      if (random.uniform() > 0.3) continue;
      const Window& other = first[random.index(first.size())];
      w.x = other.x, w.y = other.y, w.sigma = other.sigma;
    }
    if (seed % 5 != 0) return;
    second = first;  // the same ends, other images
    for (Window& w : second) {
      const Window other = random_window(3, spread, random);
      w.x = other.x, w.y = other.y, w.sigma = other.sigma, w.origin += static_cast<Index>(first.size());
    }
  }
  std::vector<Window> all() const {
    std::vector<Window> windows = first;
    windows.insert(windows.end(), second.begin(), second.end());
    return windows;
  }
};

class Merging : public testing::Test {
 protected:
  std::vector<Window> merged(const Lists& lists) {
    WindowList list, other;
    for (const Window& w : lists.first) list.push(w);
    for (const Window& w : lists.second) other.push(w);
    trimming_.merge(list, other.arrays(), other.size());
    return listed(list.arrays(), list.size());
  }
  Trimming trimming_{lanes(Simd::baseline)};
};

constexpr std::uint64_t cases = 20000;

/// Between a cut and the true place of equal distance the difference is at most that at the cut, `equal_share`; as much
/// again for the roundings of the two distances that are compared here.
TEST_F(Merging, KeepsTheNearestAtEveryPlace) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const Lists lists(seed);
    const std::vector<Window> all = lists.all(), kept = merged(lists);
    std::vector<double> ends;
    for (const auto* windows : {&all, &kept})
      for (const Window& w : *windows) ends.push_back(w.low), ends.push_back(w.high);
    Random random(seed);
    for (const double x : sample_places(length, ends, random)) {
      const double expected = nearest(all, x), seen = nearest(kept, x);
      if (std::isinf(expected) && std::isinf(seen)) continue;
      ASSERT_LE(std::abs(seen - expected), 2 * equal_share * expected) << "seed " << seed << " at " << x;
    }
  }
}

TEST_F(Merging, LeavesWhatIsDisjointAndAscending) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed) ASSERT_TRUE(in_order(merged(Lists(seed)))) << "seed " << seed;
}

TEST_F(Merging, LeavesPartsOfWhatWasGiven) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const Lists lists(seed);
    const std::vector<Window> all = lists.all();
    for (const Window& w : merged(lists)) {
      const Window& whole = all.at(w.origin);
      ASSERT_TRUE(w.x == whole.x && w.y == whole.y && w.sigma == whole.sigma) << "seed " << seed;
      ASSERT_TRUE(whole.low <= w.low && w.high <= whole.high) << "seed " << seed;
    }
  }
}

TEST_F(Merging, LeavesNoPieceThatGoesOnInTheNext) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const std::vector<Window> kept = merged(Lists(seed));
    for (std::size_t i = 1; i < kept.size(); ++i)
      ASSERT_FALSE(kept[i].origin == kept[i - 1].origin && kept[i].low == kept[i - 1].high) << "seed " << seed;
  }
}

TEST_F(Merging, WithNothingChangesNothing) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Lists lists(seed);
    lists.second.clear();
    std::vector<Window> given;
    for (const Window& w : lists.first)
      if (w.low < w.high) given.push_back(w);
    const std::vector<Window> kept = merged(lists);
    ASSERT_EQ(kept.size(), given.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      ASSERT_TRUE(kept[i].origin == given[i].origin && kept[i].low == given[i].low && kept[i].high == given[i].high);
  }
}

/// Two windows that are equally far at some place, each nearer on its own side of it within [low, high].
struct Tie {
  Window a, b;
  double low, high;
};

/// Ties of one sort: `make(random, a, b)` sets the images and returns where they are to be equally far.
template <class Make>
std::vector<Tie> random_ties(std::uint64_t seed, Make&& make) {
  Random random(seed);
  std::vector<Tie> ties;
  for (int attempt = 0; attempt < 100000 && ties.size() < 5000; ++attempt) {
    Tie tie{random_window(3, 1, random), random_window(3, 1, random), 0, 0};
    const double x = make(random, tie.a, tie.b);
    if (!std::isfinite(x)) continue;
    tie.b.sigma = 0;
    tie.b.sigma = tie.a.at(x) - tie.b.at(x);
    tie.low = x - power(random, 1e-12, 1), tie.high = x + power(random, 1e-12, 1);
    const double at_low = tie.a.at(tie.low) - tie.b.at(tie.low), at_high = tie.a.at(tie.high) - tie.b.at(tie.high);
    if (at_low * at_high < 0) ties.push_back(tie);
  }
  EXPECT_EQ(ties.size(), 5000U);
  return ties;
}

/// Equal to 8 ulp of the distance; or as near as a double can be: the two change places from it to one of the doubles
/// beside it.
testing::AssertionResult equally_far(const Tie& tie) {
  const double x = equal_place(tie.a, tie.b, tie.low, tie.high);
  if (!(tie.low <= x && x <= tie.high)) return testing::AssertionFailure() << x << " is outside";
  const auto gap = [&](double at) { return tie.a.at(at) - tie.b.at(at); };
  if (std::abs(gap(x)) <= equal_share * tie.a.at(x)) return testing::AssertionSuccess();
  const double before = gap(std::nextafter(x, -10)), behind = gap(std::nextafter(x, 10));
  if (before * gap(x) <= 0 || gap(x) * behind <= 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "differ by " << gap(x) / tie.a.at(x) << " at " << x << " of [" << tie.low
                                     << ", " << tie.high << "]";
}

/// Where the line through the images meets the half-edge.
double line_through(const Window& a, const Window& b) { return b.x + (a.x - b.x) * (b.y / (b.y - a.y)); }

TEST(EqualPlace, IsFoundForAnyImages) {
  for (const Tie& tie : random_ties(1, [](Random&random, Window&, Window&) { return random.uniform(0, length); }))
    ASSERT_TRUE(equally_far(tie));
}

/// Beside the line through the images their distances differ by nearly all of the distance between them, and the branch
/// of equal distance is a narrow one around that line.
TEST(EqualPlace, IsFoundWhereTheDifferenceOfSigmasIsNearlyThatOfTheImages) {
  for (const Tie& tie : random_ties(2, [](Random&random, Window&a, Window&b) {
         return line_through(a, b) + (random.uniform() < 0.5 ? -1 : 1) * power(random, 1e-9, 0.1);
       }))
    ASSERT_TRUE(equally_far(tie));
}

TEST(EqualPlace, IsFoundForImagesThatAreNearlyTheSame) {
  for (const Tie& tie : random_ties(3, [](Random&random, Window&a, Window&b) {
         b.x = a.x + power(random, 1e-12, 1e-3), b.y = std::min(0.0, a.y + power(random, 1e-12, 1e-3));
         return random.uniform(0, length);
       }))
    ASSERT_TRUE(equally_far(tie));
}

TEST(EqualPlace, IsFoundForImagesThatGrazeTheHalfEdge) {
  for (const Tie& tie : random_ties(4, [](Random&random, Window&a, Window&b) {
         a.y = -power(random, 1e-16, 1e-6), b.y = random.uniform() < 0.3 ? a.y : -power(random, 1e-16, 1e-6);
         return random.uniform(0, length);
       }))
    ASSERT_TRUE(equally_far(tie));
}

/// Here a distance is smaller than the places on the half-edge, so its last bits are those of the place.
TEST(EqualPlace, IsFoundForImagesCloseToTheirPlace) {
  for (const Tie& tie : random_ties(5, [](Random&random, Window&a, Window&b) {
         const double x = random.uniform(0.1, length), size = power(random, 1e-12, 1e-2);
         a = {x + size * random.uniform(-1, 0), -size * random.uniform(), 0, 0, length, 0, no_index};
         b = {x + size * random.uniform(), -size * random.uniform(), 0, 0, length, 0, no_index};
         return x;
       }))
    ASSERT_TRUE(equally_far(tie));
}

}  // namespace
}  // namespace geodrome::chen_han::test
