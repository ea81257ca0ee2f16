// SPDX-License-Identifier: MIT
#include "plugins/common/exact/lower_envelope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/plugins/common/images.hpp"

/// The lower envelope of two lists, over the images of both exact solvers.
namespace geodrome::chen_han::test {
namespace {

/// Up to `most` disjoint ascending windows; some touch.
std::vector<Window> random_list(std::size_t most, double spread, Index first_name, Random& random) {
  std::vector<double> ends(2 * random.index(most + 1));
  for (double& end : ends) end = random.uniform() < 0.1 ? usual_length : random.uniform(0, usual_length);
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

/// Windows as a list of pieces of images.
template <class Image>
struct Row {
  std::vector<Window> windows;

  std::size_t size() const { return windows.size(); }
  double low(std::size_t i) const { return windows[i].low; }
  double high(std::size_t i) const { return windows[i].high; }
  Image image(std::size_t i) const { return image_of<Image>(windows[i]); }
};

template <class Image>
class LowerEnvelopeOf : public testing::Test {
 protected:
  static std::vector<Window> merged(const Lists& lists) {
    std::vector<Window> pieces;
    lower_envelope(Row<Image>{lists.first}, Row<Image>{lists.second},
                   [&](const Row<Image>& row, std::size_t i, double low, double high) {
                     pieces.push_back(row.windows[i]);
                     pieces.back().low = low, pieces.back().high = high;
                   });
    return pieces;
  }
};
TYPED_TEST_SUITE(LowerEnvelopeOf, Images, ImageNames);

constexpr std::uint64_t cases = 20000;

/// Between a cut and the true place of equal distance the difference is at most that at the cut, `equal_share`; as much
/// again for the roundings of the two distances that are compared here.
TYPED_TEST(LowerEnvelopeOf, KeepsTheNearestAtEveryPlace) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const Lists lists(seed);
    const std::vector<Window> all = lists.all(), kept = this->merged(lists);
    std::vector<double> ends;
    for (const auto* windows : {&all, &kept})
      for (const Window& w : *windows) ends.push_back(w.low), ends.push_back(w.high);
    Random random(seed);
    for (const double x : sample_places(usual_length, ends, random)) {
      const double expected = nearest(all, x), seen = nearest(kept, x);
      if (std::isinf(expected) && std::isinf(seen)) continue;
      ASSERT_LE(std::abs(seen - expected), 2 * equal_share * expected) << "seed " << seed << " at " << x;
    }
  }
}

TYPED_TEST(LowerEnvelopeOf, LeavesWhatIsDisjointAndAscending) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed)
    ASSERT_TRUE(in_order(this->merged(Lists(seed)))) << "seed " << seed;
}

TYPED_TEST(LowerEnvelopeOf, LeavesPartsOfWhatWasGiven) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const Lists lists(seed);
    const std::vector<Window> all = lists.all();
    for (const Window& w : this->merged(lists)) {
      const Window& whole = all.at(w.origin);
      ASSERT_TRUE(w.x == whole.x && w.y == whole.y && w.sigma == whole.sigma) << "seed " << seed;
      ASSERT_TRUE(whole.low <= w.low && w.high <= whole.high) << "seed " << seed;
    }
  }
}

TYPED_TEST(LowerEnvelopeOf, LeavesNoPieceThatGoesOnInTheNext) {
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const std::vector<Window> kept = this->merged(Lists(seed));
    for (std::size_t i = 1; i < kept.size(); ++i)
      ASSERT_FALSE(kept[i].origin == kept[i - 1].origin && kept[i].low == kept[i - 1].high) << "seed " << seed;
  }
}

TYPED_TEST(LowerEnvelopeOf, WithNothingChangesNothing) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Lists lists(seed);
    lists.second.clear();
    std::vector<Window> given;
    for (const Window& w : lists.first)
      if (w.low < w.high) given.push_back(w);
    const std::vector<Window> kept = this->merged(lists);
    ASSERT_EQ(kept.size(), given.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      ASSERT_TRUE(kept[i].origin == given[i].origin && kept[i].low == given[i].low && kept[i].high == given[i].high);
  }
}

}  // namespace
}  // namespace geodrome::chen_han::test
