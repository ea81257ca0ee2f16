// SPDX-License-Identifier: MIT
#include "plugins/common/exact/image_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/plugins/common/window_scenes.hpp"

namespace geodrome::chen_han::test {
namespace {

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
  for (const Tie& tie : random_ties(1, [](Random&random, Window&, Window&) { return random.uniform(0, usual_length); }))
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
         return random.uniform(0, usual_length);
       }))
    ASSERT_TRUE(equally_far(tie));
}

TEST(EqualPlace, IsFoundForImagesThatGrazeTheHalfEdge) {
  for (const Tie& tie : random_ties(4, [](Random&random, Window&a, Window&b) {
         a.y = -power(random, 1e-16, 1e-6), b.y = random.uniform() < 0.3 ? a.y : -power(random, 1e-16, 1e-6);
         return random.uniform(0, usual_length);
       }))
    ASSERT_TRUE(equally_far(tie));
}

/// Here a distance is smaller than the places on the half-edge, so its last bits are those of the place.
TEST(EqualPlace, IsFoundForImagesCloseToTheirPlace) {
  for (const Tie& tie : random_ties(5, [](Random&random, Window&a, Window&b) {
         const double x = random.uniform(0.1, usual_length), size = power(random, 1e-12, 1e-2);
         a = {x + size * random.uniform(-1, 0), -size * random.uniform(), 0, 0, usual_length, 0, no_index};
         b = {x + size * random.uniform(), -size * random.uniform(), 0, 0, usual_length, 0, no_index};
         return x;
       }))
    ASSERT_TRUE(equally_far(tie));
}

}  // namespace
}  // namespace geodrome::chen_han::test
