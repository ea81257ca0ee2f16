// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/node_pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/plugins/solver_schreiber/rows.hpp"

namespace geodrome::schreiber::test {
namespace {

// ---- Sharing and memory

TEST(SchreiberSequence, ChangesWhatNobodyElseHoldsWhereItIs) {
  Pool pool;
  for (const int count : {10, 4000}) {
    Row row = row_of(pool, count);
    const std::size_t bytes = pool.bytes_in_use();
    const auto change = [&] {
      for (std::size_t i = 0; i < row.size(); ++i) row.set_key(i, 0);
      row.move({0, 1, 2, 3});
    };
    EXPECT_EQ(made_by(pool, change), 0u);
    EXPECT_EQ(pool.bytes_in_use(), bytes);
    const Row moved = std::move(row);
    row = moved;
    EXPECT_EQ(pool.bytes_in_use(), bytes) << "a copy holds the same nodes";
  }
  Row flat = row_of(pool, 10);
  EXPECT_EQ(made_by(pool,
                    [&] {
                      while (flat.size() > 1) flat.erase(flat.size() / 2);
                    }),
            0u);
}

TEST(SchreiberSequence, CopiesOnlyTheWayToWhatIsShared) {
  Pool pool;
  for (const int count : {10, 4000}) {
    Row row = row_of(pool, count);
    const std::size_t depth = depth_of(pool, row, 5);
    EXPECT_EQ(depth > 0, !row.is_flat());
    {
      const Row copy = row;
      const std::vector<Named> before = items_of(copy);
      EXPECT_EQ(made_by(pool, [&] { row.set_key(5, 1); }), depth + 1);
      EXPECT_EQ(made_by(pool, [&] { row.set_key(5, 2); }), 0u) << "the way is its own now";
      EXPECT_EQ(made_by(pool, [&] { row.move({0, 1, 2, 3}); }), 0u);
      EXPECT_EQ(items_of(copy), before);
      EXPECT_EQ(copy.least_key(), 100);
      EXPECT_EQ(row[5].key, 2);
      EXPECT_EQ(row.least_key(), 2);
    }
    const auto change_all = [&] {
      for (std::size_t i = 0; i < row.size(); ++i) row.set_key(i, 0);
    };
    EXPECT_EQ(made_by(pool, change_all), 0u) << "the copy is gone";
  }
}

TEST(SchreiberSequence, EveryWayOfLettingGoGivesTheMemoryBack) {
  Pool pool;
  {
    Row row = row_of(pool, 2000), copy = row, other = row_of(pool, 3);
    copy = other;                  // lets the shared one go
    row = std::move(other);        // lets the last holder go
    row = static_cast<Row&>(row);  // itself
    EXPECT_EQ(names_of(row), names_from(0, 3));
    EXPECT_EQ(made_by(pool, [&] { copy.set_key(0, 0), row.set_key(0, 0); }), 1u) << "two held the same leaf";
    copy = Row();
    const std::size_t bytes = pool.bytes_in_use();
    row = row_of(pool, 3);
    EXPECT_EQ(pool.bytes_in_use(), bytes);
    row = row_of(pool, 400);
    row.split(30);  // the rest is dropped
    copy = Row();
    while (!row.empty()) row.erase(0);
    EXPECT_EQ(pool.bytes_in_use(), 0u);
    row.append(row_of(pool, 40));
    EXPECT_EQ(row.size(), 40u);
  }
  EXPECT_EQ(pool.bytes_in_use(), 0u);
  EXPECT_GT(pool.bytes(), 0u);
}

TEST(SchreiberSequence, UsesFreedMemoryAgain) {
  Pool pool;
  const auto round = [&](Row& row, Random& random) {
    for (int step = 0; step < 1000; ++step) {  // cut and put together in the other order
      Row rest = row.split(random.below(row.size()));
      rest.append(std::move(row));
      row = std::move(rest);
      const Row copy = row;
      row.set_key(random.below(row.size()), step);
    }
  };
  Random random(4);
  Row row = row_of(pool, 1000);
  const std::size_t at_first = pool.bytes_in_use();
  for (int i = 0; i < 3; ++i) round(row, random);
  const std::size_t pages = pool.bytes();
  for (int i = 0; i < 20; ++i) {
    round(row, random);
    EXPECT_EQ(row.size(), 1000u);
    EXPECT_LE(pool.bytes_in_use(), 2 * at_first) << "leaves stay filled by half";
  }
  EXPECT_LE(pool.bytes(), 2 * pages);
}

// ---- Balance and cost

TEST(SchreiberSequence, IsBalancedAndItsLeavesFullWhenItemsAreAppended) {
  Pool pool;
  for (const int count : {1, 16, 17, 100, 1000, 4000}) {
    const Row row = row_of(pool, count);
    const Shape shape = shape_of(pool, row);
    EXPECT_TRUE(shape.balanced) << count;
    EXPECT_EQ(shape.leaves, full_leaves(row.size()));
  }
}

TEST(SchreiberSequence, IsBalancedWhenItemsArePutBefore) {
  Pool pool;
  Row row(pool);
  for (int i = 4000; i-- > 0;) {
    Row longer(pool, numbered(i));
    longer.append(std::move(row));
    row = std::move(longer);
  }
  EXPECT_EQ(names_of(row), names_from(0, 4000));
  const Shape shape = shape_of(pool, row);
  EXPECT_TRUE(shape.balanced);
  EXPECT_EQ(shape.leaves, full_leaves(4000));
}

TEST(SchreiberSequence, IsBalancedWhenPartsOfAllLengthsAreJoined) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Pool pool;
    Row row(pool);
    int count = 0;
    while (count < 3000) {
      const int more = 1 + static_cast<int>(std::exp2(random.uniform(0, 9)));
      if (random.below(2)) {
        row.append(row_of(pool, more));
      } else {
        Row longer = row_of(pool, more);
        longer.append(std::move(row));
        row = std::move(longer);
      }
      count += more;
    }
    EXPECT_TRUE(shape_of(pool, row).balanced);
    for (int i = 0; i < 300; ++i) {  // parts are cut out and put elsewhere
      const std::size_t begin = random.below(row.size());
      Row part = row.split(begin);
      Row end = part.split(1 + random.below(part.size()));
      row.append(std::move(end));
      end = row.split(random.below(row.size() + 1));
      row.append(std::move(part)), row.append(std::move(end));
    }
    EXPECT_EQ(row.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(shape_of(pool, row).balanced);
    while (row.size() > 100) row.erase(random.below(row.size()));
    EXPECT_TRUE(shape_of(pool, row).balanced);
  }
}

TEST(SchreiberSequence, SplitAndAppendTouchFewNodes) {
  Pool pool;
  Random random(5);
  Row row = row_of(pool, 4000);
  const std::size_t height = shape_of(pool, row).height;
  for (int i = 0; i < 2000; ++i) {
    const Row copy = row;
    Row rest;
    // A level is opened and closed once on the way down and once when parts are joined, by three nodes at most.
    EXPECT_LE(made_by(pool, [&] { rest = row.split(random.below(4000)); }), 6 * (height + 1));
    EXPECT_LE(made_by(pool, [&] { row.append(std::move(rest)); }), 6 * (height + 1));
    EXPECT_EQ(made_by(pool, [&] { row.first_key_at_most(random.uniform(0, 5000), random.below(4000)); }), 0u);
    if (i % 2) row = copy;
  }
}

}  // namespace
}  // namespace geodrome::schreiber::test
