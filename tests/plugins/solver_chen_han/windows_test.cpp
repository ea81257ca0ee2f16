// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/windows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "plugins/solver_chen_han/window_store.hpp"
#include "tests/plugins/solver_chen_han/named_windows.hpp"

namespace geodrome::chen_han {
namespace {

using test::Random;

TEST(WindowArrays, MembersDoNotOverlap) {
  std::vector<double> memory(7 * WindowArrays::doubles_per_window);
  const WindowArrays windows(memory.data(), 7);
  fill(windows, 7, 0);
  EXPECT_TRUE(holds(windows, 7, 0));
}

TEST(WindowArrays, WithoutTheFirstTheRestFollows) {
  std::vector<double> memory(7 * WindowArrays::doubles_per_window);
  const WindowArrays windows(memory.data(), 7);
  fill(windows, 7, 0);
  EXPECT_TRUE(holds(windows.without(3), 4, 3));
}

TEST(WindowArrays, AWindowOfNoWidthIsEmptyAndSoIsOneOfNoNumbers) {
  std::vector<double> memory(3 * WindowArrays::doubles_per_window);
  const WindowArrays windows(memory.data(), 3);
  windows.set(0, {0, -1, 0, 1, 1, 0, 0});
  windows.set(1, {0, -1, 0, 1, std::nan(""), 0, 0});
  windows.set(2, {0, -1, 0, 1, 1.5, 0, 0});
  EXPECT_TRUE(windows.empty(0));
  EXPECT_TRUE(windows.empty(1));
  EXPECT_FALSE(windows.empty(2));
}

TEST(WindowArrays, DistancesAreSigmaPlusTheWayFromTheImage) {
  std::vector<double> memory(WindowArrays::doubles_per_window);
  const WindowArrays windows(memory.data(), 1);
  windows.set(0, {1, -3, 10, 0, 9, 0, 0});
  EXPECT_EQ(windows.at(0, 5), 15);
  EXPECT_EQ(windows.to(0, 6, 9), 23);
  EXPECT_EQ(windows.get(0).at(5), 15);
}

TEST(CopyWindows, CopiesEveryCountAndNoMoreThanItsRoom) {
  constexpr std::size_t room = 40;
  std::vector<double> from_memory(room * WindowArrays::doubles_per_window), to_memory(from_memory.size());
  const WindowArrays from(from_memory.data(), room), to(to_memory.data(), room);
  fill(from, room, 0);
  for (std::size_t count = 0; count <= 32; ++count) {
    fill(to, room, 1000);
    copy_windows(from, count, to);
    EXPECT_TRUE(holds(to, count, 0)) << count;
    const std::size_t touched = room_for_copy(count);
    EXPECT_TRUE(holds(to.without(touched), room - touched, 1000 + static_cast<Index>(touched))) << count;
  }
}

TEST(WindowList, KeepsItsWindowsWhileItGrows) {
  WindowList list;
  for (Index i = 0; i < 5000; ++i) list.push(named(i));
  ASSERT_EQ(list.size(), 5000U);
  EXPECT_TRUE(holds(list.arrays(), 5000, 0));
}

TEST(WindowList, BecomesACopyWithTheRoomThatIsAskedFor) {
  WindowList list, other;
  for (Index i = 0; i < 300; ++i) other.push(named(i));
  for (const std::size_t count : {0, 1, 4, 7, 200})
    for (const std::size_t room : {0, 5, 1000}) {
      list.assign({other.arrays().without(3), count}, room);
      ASSERT_EQ(list.size(), count);
      EXPECT_TRUE(holds(list.span().windows, count, 3));
      fill(list.arrays(), room, 7);  // the sanitizers see a write that is out of bounds
    }
}

TEST(WindowList, HasRoomForTwoRegistersMoreAtEverySize) {
  WindowList list;
  for (Index i = 0; i < 200; ++i) {
    list.push(named(i));
    fill(list.arrays().without(list.size()), 2 * most_lanes, 1000);
    EXPECT_TRUE(holds(list.arrays(), list.size(), 0));
  }
}

TEST(WindowList, KeepsItsMemoryWhenItIsCleared) {
  WindowList list;
  for (Index i = 0; i < 5000; ++i) list.push(named(i));
  const std::size_t bytes = list.bytes();
  list.clear();
  EXPECT_TRUE(list.empty());
  for (Index i = 0; i < 5000; ++i) list.push(named(i));
  EXPECT_EQ(list.bytes(), bytes);
}

TEST(WindowStore, UsesAReleasedBlockForTheNextOneOfThatSize) {
  WindowStore store;
  Block& block = store.add(10);
  store.release(block);
  EXPECT_EQ(&store.add(10), &block);
}

TEST(WindowStore, FindsABlockByItsNumber) {
  WindowStore store;
  std::vector<Block*> blocks;
  for (std::size_t count = 1; count < 3000; count += count / 3 + 1) blocks.push_back(&store.add(count));
  for (const Block* block : blocks) EXPECT_EQ(&store[block->number], block);
}

TEST(WindowStore, ANewBlockHasItsCountAndNothingOfTheOneBefore) {
  WindowStore store;
  Block& old = store.add(10);
  old.next = 7;
  store.release(old);
  const Block& block = store.add(9);
  EXPECT_EQ(block.count, 9U);
  EXPECT_EQ(block.next, no_index);
}

/// At most a quarter is waste, above the smallest sizes.
TEST(WindowStore, EveryCountFitsInWholeRegistersAndLittleMore) {
  WindowStore store;
  for (std::size_t count = 1; count <= 3000; ++count) {
    const Block& block = store.add(count);
    ASSERT_GE(block.capacity, count);
    ASSERT_EQ(block.capacity % most_lanes, 0U);
    ASSERT_LE(block.capacity, std::max<std::size_t>(4 * most_lanes, (count + most_lanes) * 5 / 4)) << count;
  }
}

TEST(WindowStore, BlocksKeepTheirWindowsWhileOthersComeAndGo) {
  Random random(3);
  WindowStore store;
  std::map<Index, std::pair<std::size_t, Index>> live;  // count, name of the first window
  for (Index step = 0; step < 20000; ++step) {
    if (random.below(2) == 0 || live.empty()) {
      const std::size_t count = random_count(random);
      Block& block = store.add(count);
      ASSERT_TRUE(live.emplace(block.number, std::pair(count, 1000 * step)).second);
      fill(block.windows(), block.capacity, 1000 * step);
    } else {
      const auto it = std::next(live.begin(), static_cast<std::ptrdiff_t>(random.below(live.size())));
      ASSERT_TRUE(holds(store[it->first].windows(), it->second.first, it->second.second)) << step;
      store.release(store[it->first]);
      live.erase(it);
    }
  }
}

/// Each round needs the same blocks: what the first one took serves them all.
TEST(WindowStore, DoesNotGrowOverRoundsOfTheSameNeed) {
  WindowStore store;
  std::size_t after_first = 0;
  for (int round = 0; round < 200; ++round) {
    Random random(8);
    std::vector<Block*> live;
    for (int step = 0; step < 500; ++step) {
      if (random.below(3) > 0 || live.empty()) {
        live.push_back(&store.add(random_count(random)));
      } else {
        const std::size_t at = random.below(live.size());
        store.release(*live[at]);
        live.erase(live.begin() + static_cast<std::ptrdiff_t>(at));
      }
    }
    for (Block* block : live) store.release(*block);
    if (round == 0) after_first = store.bytes();
    ASSERT_EQ(store.bytes(), after_first) << "round " << round;
  }
}

}  // namespace
}  // namespace geodrome::chen_han
