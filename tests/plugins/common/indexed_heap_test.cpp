// SPDX-License-Identifier: MIT
#include "geodrome/solver_kit/indexed_heap.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/samples.hpp"

namespace geodrome {
namespace {

std::vector<Index> emptied(IndexedHeap& heap) {
  std::vector<Index> order;
  while (!heap.empty()) order.push_back(heap.pop());
  return order;
}

TEST(IndexedHeap, GivesTheLowestKeyFirst) {
  IndexedHeap heap(6);
  for (const auto& [element, key] : {std::pair(4, 0.5), {0, 3.0}, {2, 0.0}, {5, 2.0}, {1, 0.25}})
    heap.push(static_cast<Index>(element), key);
  EXPECT_EQ(emptied(heap), (std::vector<Index>{2, 1, 4, 5, 0}));
}

/// A start distance of -0 is a valid one.
TEST(IndexedHeap, TakesNegativeZeroForZero) {
  IndexedHeap heap(3);
  heap.push(0, 1), heap.push(1, -0.0), heap.push(2, 0.5);
  EXPECT_EQ(heap.top_key(), 0);
  EXPECT_EQ(emptied(heap), (std::vector<Index>{1, 2, 0}));
}

TEST(IndexedHeap, GivesEqualKeysByElement) {
  IndexedHeap heap(40);
  for (Index i = 0; i < 40; ++i) heap.push(i * 7 % 40, 1);
  const std::vector<Index> order = emptied(heap);
  for (Index i = 0; i < 40; ++i) EXPECT_EQ(order[i], i);
}

TEST(IndexedHeap, ShowsTheKeyOfWhatComesNext) {
  IndexedHeap heap(3);
  heap.push(1, 5);
  heap.push(2, 4);
  EXPECT_EQ(heap.top_key(), 4);
  heap.pop();
  EXPECT_EQ(heap.top_key(), 5);
}

TEST(IndexedHeap, TakesALowerKeyOfAnElementThatItHolds) {
  IndexedHeap heap(3);
  heap.push(0, 1);
  heap.push(1, 2);
  heap.push(2, 3);
  heap.push(2, 0);
  EXPECT_EQ(heap.top_key(), 0);
  EXPECT_EQ(emptied(heap), (std::vector<Index>{2, 0, 1}));
}

TEST(IndexedHeap, IgnoresAHigherKeyOfAnElementThatItHolds) {
  IndexedHeap heap(2);
  heap.push(0, 1);
  heap.push(1, 2);
  heap.push(0, 3);
  EXPECT_EQ(emptied(heap), (std::vector<Index>{0, 1}));
}

TEST(IndexedHeap, HoldsAnElementFromPushToPop) {
  IndexedHeap heap(2);
  EXPECT_FALSE(heap.holds(1));
  heap.push(1, 0);
  EXPECT_TRUE(heap.holds(1));
  heap.pop();
  EXPECT_FALSE(heap.holds(1));
}

TEST(IndexedHeap, TakesAnElementAgainAfterItsPopWithAnyKey) {
  IndexedHeap heap(2);
  heap.push(0, 1);
  heap.pop();
  heap.push(0, 9);
  EXPECT_EQ(heap.top_key(), 9);
}

TEST(IndexedHeap, IsAsNewAfterClear) {
  IndexedHeap heap(9);
  for (Index i = 0; i < 9; ++i) heap.push(i, 10.0 - i);
  heap.clear();
  EXPECT_TRUE(heap.empty());
  for (Index i = 0; i < 9; ++i) EXPECT_FALSE(heap.holds(i));
  for (Index i = 9; i-- > 0;) heap.push(i, i);  // all keys but one are higher than before
  const std::vector<Index> order = emptied(heap);
  for (Index i = 0; i < 9; ++i) EXPECT_EQ(order[i], i);
}

TEST(IndexedHeap, KeepsItsMemoryWhenItIsCleared) {
  IndexedHeap heap(100);
  for (Index i = 0; i < 100; ++i) heap.push(i, i);
  const std::size_t bytes = heap.bytes();
  heap.clear();
  for (Index i = 0; i < 100; ++i) heap.push(i, 100.0 - i);
  EXPECT_EQ(heap.bytes(), bytes);
}

/// The same operations on a sorted set. Keys are few, so that many tie.
TEST(IndexedHeap, AgreesWithASortedSetOnRandomOperations) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    test::Random random(seed);
    const std::size_t count = 1 + random.below(200);
    IndexedHeap heap(count);
    std::set<std::pair<double, Index>> expected;
    std::map<Index, double> key_of;
    for (int step = 0; step < 5000; ++step) {
      const double share = random.uniform();
      if (share < 0.002) {
        heap.clear(), expected.clear(), key_of.clear();
      } else if (share < 0.35 && !expected.empty()) {
        ASSERT_EQ(heap.top_key(), expected.begin()->first) << "seed " << seed << " step " << step;
        const Index popped = heap.pop();
        ASSERT_EQ(popped, expected.begin()->second) << "seed " << seed << " step " << step;
        expected.erase(expected.begin()), key_of.erase(popped);
      } else {
        const auto element = static_cast<Index>(random.below(count));
        const auto key = static_cast<double>(random.below(50));
        heap.push(element, key);
        const auto held = key_of.find(element);
        if (held != key_of.end() && held->second <= key) continue;
        if (held != key_of.end()) expected.erase({held->second, element});
        expected.insert({key, element}), key_of[element] = key;
      }
      ASSERT_EQ(heap.empty(), expected.empty());
    }
  }
}

}  // namespace
}  // namespace geodrome
