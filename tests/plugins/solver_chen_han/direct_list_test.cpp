// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/direct_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>

#include "tools/shapes/random.hpp"

/// Which paths of a list one that arrives may go on by, judged path by path.
namespace geodrome::test {
namespace {

using namespace chen_han;

/// Paths with exits at random, in order, the first `any` of them for any arrival; targets are their numbers.
std::vector<FoundPath> random_paths(std::size_t count, std::size_t any, bool closed, shapes::Random& random) {
  std::vector<FoundPath> paths(count);
  for (FoundPath& path : paths)
    path = {1, 0, static_cast<DirectionCode>(random.index(closed ? full_angle : full_angle + 1)), to_all_sides};
  std::sort(paths.begin() + static_cast<std::ptrdiff_t>(any), paths.end(),
            [](const FoundPath& a, const FoundPath& b) { return a.exit < b.exit; });
  for (std::size_t i = 0; i < count; ++i) paths[i].target = static_cast<Index>(i);
  return paths;
}

std::set<Index> targets(const DirectList& list, Onward onward) {
  std::set<Index> found;
  for (std::size_t i = 0; i < onward.count; ++i)
    found.insert(list.directed()[(onward.first + i) % list.directed().size()].target);
  EXPECT_EQ(found.size(), onward.count);
  return found;
}

TEST(DirectList, LetsPathsGoOnThatAreFarEnoughFromTheArrival) {
  shapes::Random random(6);
  for (int draw = 0; draw < 500; ++draw) {
    const bool closed = random.index(2) == 0;
    const auto half_turn = static_cast<DirectionCode>(random.index(4) == 0 ? 0 : 20000 + random.index(15000));
    const std::size_t count = random.index(90), any = std::min<std::size_t>(count, random.index(4));
    const std::vector<FoundPath> paths = random_paths(count, any, closed, random);
    const DirectList list(paths, any, half_turn, closed);
    const auto arrival = static_cast<DirectionCode>(random.index(10) == 0 ? to_all_sides : random.index(full_angle));
    std::set<Index> expected;
    for (std::size_t i = any; i < count; ++i) {
      int apart = std::abs(paths[i].exit - arrival);
      if (closed) apart = std::min(apart, full_angle - apart);
      if (arrival == to_all_sides || apart >= half_turn) expected.insert(static_cast<Index>(i));
    }
    const Onward onward = list.onward(arrival);
    EXPECT_EQ(targets(list, onward), expected);
    EXPECT_EQ(onward.ends(), expected.empty() && any == 0);
    EXPECT_EQ(list.is_all(onward), !onward.ends() && expected.size() == count - any);
    EXPECT_TRUE(list.onward(ends_here).ends());
    EXPECT_EQ(list.for_any().size(), any);
  }
}

/// 16 bits count paths in groups then: a few too many may be gone on by, none too few, none twice.
TEST(DirectList, HoldsMorePathsThan16BitsCount) {
  shapes::Random random(8);
  for (const std::size_t count : {65534U, 65535U, 65536U, 131069U, 300000U}) {
    const std::size_t group = 1 + (count - 1) / 65534;
    const bool closed = random.index(2) == 0;
    const DirectionCode half_turn = 20000;
    const std::vector<FoundPath> paths = random_paths(count, 3, closed, random);
    const DirectList list(paths, 3, half_turn, closed);
    for (const DirectionCode arrival : {0, 9, 20000, 32766, 45000, 65531, int{to_all_sides}}) {
      const Onward onward = list.onward(arrival);
      std::vector<int> times(count);
      for (const auto& piece : list.directed(onward))
        for (const DirectPath& path : piece) ++times[path.target];
      std::size_t needed = 0;
      for (std::size_t i = 3; i < count; ++i) {
        int apart = std::abs(paths[i].exit - arrival);
        if (closed) apart = std::min(apart, full_angle - apart);
        const bool goes_on = arrival == to_all_sides || apart >= half_turn;
        needed += goes_on;
        ASSERT_LE(times[i], 1) << count;
        if (goes_on) {
          ASSERT_EQ(times[i], 1) << i << " of " << count << " from " << arrival;
        }
      }
      EXPECT_LE(std::accumulate(times.begin(), times.end(), std::size_t{0}), needed + 2 * (group - 1));
      EXPECT_EQ(list.is_all(onward), arrival == to_all_sides);
    }
  }
}

TEST(DirectList, IsCompletedByTheListsOfItsTargets) {
  shapes::Random random(7);
  std::vector<DirectList> lists(20);
  std::vector<std::vector<FoundPath>> paths;
  for (DirectList& list : lists) {
    paths.push_back(random_paths(20, 2, true, random));
    for (FoundPath& path : paths.back()) path.arrival = static_cast<DirectionCode>(random.index(full_angle));
    list = DirectList(paths.back(), 2, 30000, true);
  }
  for (DirectList& list : lists) list.complete(lists);
  for (std::size_t i = 0; i < lists.size(); ++i)
    for (std::size_t p = 0; p < 20; ++p) {
      const Onward expected = lists[paths[i][p].target].onward(paths[i][p].arrival);
      EXPECT_EQ(lists[i].paths()[p].onward.first, expected.first);
      EXPECT_EQ(lists[i].paths()[p].onward.count, expected.count);
    }
}

}  // namespace
}  // namespace geodrome::test
