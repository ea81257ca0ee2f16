// SPDX-License-Identifier: MIT
#include "plugins/common/mesh/bucket_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tools/shapes/random.hpp"

namespace geodrome {
namespace {

using shapes::Random;

/// Takes an entry and pushes some that are not before it, until nothing is left. Returns the keys in their order.
std::vector<float> taken(BucketQueue& queue, Random& random, std::size_t more, double farthest) {
  std::vector<float> keys;
  while (!queue.empty()) {
    const BucketQueue::Entry entry = queue.pop();
    keys.push_back(entry.key);
    for (; more > 0 && random.uniform(0, 1) < 0.7; --more)
      queue.push(static_cast<Index>(more), entry.key + static_cast<float>(random.uniform(0, farthest)));
  }
  return keys;
}

TEST(BucketQueue, GivesBackEveryEntryOnce) {
  Random random(1);
  for (const double farthest : {0.01, 1.0, 1e4, 1e18}) {
    BucketQueue queue;
    std::map<Index, int> left;
    for (Index i = 0; i < 5000; ++i) {
      queue.push(i % 3000, static_cast<float>(random.uniform(0, farthest)));
      ++left[i % 3000];
    }
    while (!queue.empty()) --left[queue.pop().element];
    for (const auto& [element, count] : left) EXPECT_EQ(count, 0) << element;
  }
}

/// No entry is taken later than one that lies a bucket behind it.
TEST(BucketQueue, IsInOrderUpToABucket) {
  Random random(2);
  for (const double farthest : {0.3, 3.0, 3000.0}) {
    BucketQueue queue;
    for (Index i = 0; i < 100; ++i) queue.push(i, static_cast<float>(random.uniform(0, farthest)));
    const std::vector<float> keys = taken(queue, random, 20000, farthest);
    EXPECT_GT(keys.size(), 10000u);
    float highest = 0;
    for (const float key : keys) {
      EXPECT_GE(key, highest - 1.01F / BucketQueue::buckets_a_unit);
      highest = std::max(highest, key);
    }
  }
}

/// Where all keys lie in one bucket, entries come lowest first as soon as many came while it was open.
TEST(BucketQueue, SortsABucketThatFillsUp) {
  Random random(3);
  BucketQueue queue;
  queue.push(0, 0);
  queue.pop();
  for (Index i = 0; i < 1000; ++i)
    queue.push(i, static_cast<float>(random.uniform(0, 0.96 / BucketQueue::buckets_a_unit)));
  float last = 0;
  while (!queue.empty()) {
    const float key = queue.pop().key;
    EXPECT_GE(key, last);
    last = key;
  }
}

TEST(BucketQueue, IsAsNewAfterClear) {
  BucketQueue queue;
  for (Index i = 0; i < 100; ++i) queue.push(i, static_cast<float>(i * 1000));
  queue.pop();
  queue.clear();
  EXPECT_TRUE(queue.empty());
  queue.push(7, 0.5F);
  EXPECT_EQ(queue.pop().element, 7u);
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace geodrome
