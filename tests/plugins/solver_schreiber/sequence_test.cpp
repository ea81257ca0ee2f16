// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/sequence.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/plugins/solver_schreiber/rows.hpp"

namespace geodrome::schreiber::test {
namespace {

TEST(SchreiberSequence, OneOfNothingAnswersLikeAnEmptyOne) {
  Pool pool;
  for (Row row : {Row(), Row(pool)}) {
    EXPECT_TRUE(row.empty());
    EXPECT_TRUE(row.is_flat());
    EXPECT_EQ(row.size(), 0u);
    EXPECT_EQ(row.least_key(), Row::none);
    EXPECT_EQ(row.first_key_at_most(Row::none, 0), 0u);
    EXPECT_TRUE(items_of(row).empty());
    row.move({0, 1, 2, 3});
    EXPECT_TRUE(row.split(0).empty());
    row.append(Row());
    EXPECT_TRUE(row.empty());
    row.append(row_of(pool, 2));
    EXPECT_EQ(items_of(row), items_of(row_of(pool, 2))) << "a motion of nothing stays behind";
  }
  EXPECT_EQ(pool.bytes_in_use(), 0u);
}

TEST(SchreiberSequence, IsOneArrayAsLongAsALeafHoldsIt) {
  Pool pool;
  const int most = static_cast<int>(leaf_size);
  for (int count = 0; count <= most; ++count) EXPECT_TRUE(row_of(pool, count).is_flat()) << count;
  EXPECT_FALSE(row_of(pool, most + 1).is_flat());
}

TEST(SchreiberSequence, KeepsOrderWhateverIsJoined) {
  Pool pool;
  for (int left = 0; left <= 150; left += left < 40 ? 1 : 23)
    for (int right = 0; right <= 150; right += right < 40 ? 1 : 23) {
      Row row = row_of(pool, left);
      row.append(row_of(pool, right, left));
      ASSERT_EQ(names_of(row), names_from(0, left + right)) << left << " and " << right;
    }
}

TEST(SchreiberSequence, SplitsAtEveryPlaceAndIsTheSameWhenJoinedAgain) {
  Pool pool;
  for (const int count : {1, 2, 15, 16, 17, 33, 150}) {
    Row row = row_of(pool, count);
    for (int i = 0; i <= count + 1; ++i) {
      Row rest = row.split(static_cast<std::size_t>(i));
      const int kept = std::min(i, count);
      ASSERT_EQ(names_of(row), names_from(0, kept)) << count << " at " << i;
      ASSERT_EQ(names_of(rest), names_from(kept, count - kept)) << count << " at " << i;
      row.append(std::move(rest));
      ASSERT_EQ(shape_of(pool, row).leaves, full_leaves(row.size())) << count << " at " << i;
      ASSERT_EQ(names_of(row), names_from(0, count)) << count << " at " << i;
    }
  }
}

TEST(SchreiberSequence, ErasesTheItemAtEveryPlace) {
  Pool pool;
  for (const int count : {1, 2, 15, 16, 17, 33, 150}) {
    const Row row = row_of(pool, count);
    for (int i = 0; i < count; ++i) {
      Row less = row;
      less.erase(static_cast<std::size_t>(i));
      std::vector<int> expected = names_from(0, count);
      expected.erase(expected.begin() + i);
      ASSERT_EQ(names_of(less), expected) << count << " at " << i;
    }
  }
}

TEST(SchreiberSequence, AppendsToItself) {
  Pool pool;
  for (const int count : {1, 8, 9, 16, 17, 100}) {
    Row row = row_of(pool, count);
    row.move({0, 1, 5, 6});
    std::vector<Named> expected = items_of(row);
    for (int i = 0; i < count; ++i) expected.push_back(expected[static_cast<std::size_t>(i)]);
    row.append(row);
    EXPECT_EQ(items_of(row), expected) << count;
    row.set_key(0, -1);  // the halves share nodes
    EXPECT_EQ(row[static_cast<std::size_t>(count)].key, 100);
    expected[0].key = -1;
    EXPECT_EQ(items_of(row), expected) << count;
  }
}

TEST(SchreiberSequence, TheMotionOfEachPartIsItsOwn) {
  Pool pool;
  Row row = row_of(pool, 100), other = row_of(pool, 100, 100);
  row.move({0, 1, 1000, 0});
  other.move({-1, 0, 0, 1000});
  row.append(other);
  Row rest = row.split(50);
  rest.move({1, 0, 7, 7});
  EXPECT_EQ(row.front(), numbered(0).moved({0, 1, 1000, 0}));
  EXPECT_EQ(row.back(), numbered(49).moved({0, 1, 1000, 0}));
  EXPECT_EQ(rest.front(), numbered(50).moved({0, 1, 1007, 7}));
  EXPECT_EQ(rest.back(), numbered(199).moved({-1, 0, 7, 1007}));
  EXPECT_EQ(other.front(), numbered(100).moved({-1, 0, 0, 1000}));
}

TEST(SchreiberSequence, UpdateGivesTheStoredItemAndTheMotionToTheFrame) {
  Pool pool;
  Row row = row_of(pool, 200);
  row.move({0, 1, 3, 4});
  Row end = row_of(pool, 200, 200);
  end.move({0, -1, 5, 6});
  row.append(std::move(end));
  row.move({-1, 0, 1, 2});
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Named before = row[i];
    row.update(i, [&](Named& stored, const Motion& to_frame) {
      EXPECT_EQ(stored.moved(to_frame), before) << i;
      stored = Named{1, 2, 3, 4}.moved(to_frame.inverse());
    });
    EXPECT_EQ(row[i], (Named{1, 2, 3, 4})) << i;
  }
}

TEST(SchreiberSequence, FindsKeysInOrder) {
  Pool pool;
  for (const int count : {10, 800}) {
    Row row = row_of(pool, count);
    const std::size_t size = row.size();
    row.set_key(3, 5), row.set_key(7, 4), row.set_key(8, 5);
    EXPECT_EQ(row.least_key(), 4);
    EXPECT_EQ(row.first_key_at_most(5, 0), 3u);
    EXPECT_EQ(row.first_key_at_most(5, 3), 3u);
    EXPECT_EQ(row.first_key_at_most(5, 4), 7u);
    EXPECT_EQ(row.first_key_at_most(5, 8), 8u);
    EXPECT_EQ(row.first_key_at_most(5, 9), size);
    EXPECT_EQ(row.first_key_at_most(3.9, 0), size);
    EXPECT_EQ(row.first_key_at_most(Row::none, size - 1), size - 1);
    EXPECT_EQ(row.first_key_at_most(Row::none, size), size);
    EXPECT_EQ(row.first_key_at_most(Row::none, size + 1), size);
    row.erase(7);
    EXPECT_EQ(row.least_key(), 5);
    row.set_key(3, Row::none), row.set_key(7, Row::none);
    EXPECT_EQ(row.least_key(), 100);
  }
}

}  // namespace
}  // namespace geodrome::schreiber::test
