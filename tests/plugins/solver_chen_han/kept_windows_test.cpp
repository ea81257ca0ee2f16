// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/kept_windows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "tests/plugins/solver_chen_han/named_windows.hpp"

namespace geodrome::chen_han {
namespace {

using test::Random;

/// Keeps passes of random sizes under random half-edges, so that pages are crossed and half-edges have many passes.
class KeptPasses : public testing::Test {
 protected:
  static constexpr std::size_t half_edges = 30;

  void keep(std::size_t passes, std::uint64_t seed) {
    Random random(seed);
    expected_.assign(half_edges, {});
    half_edge_.clear();
    for (std::size_t p = 0; p < passes; ++p) {
      const auto half_edge = static_cast<Index>(random.below(half_edges));
      const std::size_t count = random_count(random);
      list_.clear();
      for (std::size_t i = 0; i < count; ++i) list_.push(named(static_cast<Index>(half_edge_.size() + i)));
      ASSERT_EQ(kept_.keep(half_edge, list_.arrays(), count), half_edge_.size());
      for (std::size_t i = 0; i < count; ++i) {
        expected_[half_edge].insert(static_cast<Index>(half_edge_.size()));
        half_edge_.push_back(half_edge);
      }
    }
  }
  std::set<Index> visited(Index half_edge) const {
    std::set<Index> numbers;
    kept_.for_each(half_edge, [&](Index number, const Window& window) {
      EXPECT_TRUE(same(window, named(number)));
      EXPECT_TRUE(numbers.insert(number).second) << "twice: " << number;
    });
    return numbers;
  }
  void expect_all_kept() const {
    ASSERT_EQ(kept_.size(), half_edge_.size());
    for (Index w = 0; w < half_edge_.size(); ++w) {
      ASSERT_TRUE(same(kept_[w], named(w))) << w;
      ASSERT_EQ(kept_.half_edge_of(w), half_edge_[w]) << w;
    }
    for (Index h = 0; h < half_edges; ++h) EXPECT_EQ(visited(h), expected_[h]) << h;
  }

  KeptWindows kept_;
  WindowList list_;
  std::vector<std::set<Index>> expected_;
  std::vector<Index> half_edge_;
};

TEST_F(KeptPasses, AreFoundByNumberAndByHalfEdge) {
  kept_.prepare(half_edges);
  keep(1000, 1);
  expect_all_kept();
}

TEST_F(KeptPasses, AreForgottenByReset) {
  kept_.prepare(half_edges);
  keep(50, 1);
  kept_.reset();
  EXPECT_EQ(kept_.size(), 0U);
  for (Index h = 0; h < half_edges; ++h) EXPECT_TRUE(visited(h).empty());
}

TEST_F(KeptPasses, OfALaterRunAreNotMixedWithThoseBefore) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    kept_.reset();
    kept_.prepare(half_edges);
    keep(100 * seed, seed);
    expect_all_kept();
  }
}

TEST_F(KeptPasses, TakeNoMoreMemoryTheSecondTime) {
  kept_.prepare(half_edges);
  keep(300, 1);
  const std::size_t bytes = kept_.bytes();
  kept_.reset();
  keep(300, 1);
  EXPECT_EQ(kept_.bytes(), bytes);
}

/// The place where the straight line from the image crosses the half-edge decides which way it is.
TEST(WayThrough, IsStraightWithinTheWindowAndBentAtItsNearerEndBesideIt) {
  const Window window{0, -3, 10, -1, 1, 0, 0};
  EXPECT_EQ(way_through(window, 0, 2, INFINITY), 15);
  const double leg = std::sqrt(10.0);
  EXPECT_DOUBLE_EQ(way_through(window, 4, 1, INFINITY), 10 + leg + leg);
  EXPECT_DOUBLE_EQ(way_through(window, -4, 1, INFINITY), 10 + leg + leg);
}

}  // namespace
}  // namespace geodrome::chen_han
