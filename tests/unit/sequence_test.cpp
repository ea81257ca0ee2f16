// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "support/samples.hpp"

namespace geodrome::schreiber {
namespace {

using test::Random;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Named {
  double x, y, key;
  int name;

  Named moved(const Motion& motion) const {
    const auto [mx, my] = motion(x, y);
    return {mx, my, key, name};
  }
};
bool operator==(const Named& a, const Named& b) {
  return a.x == b.x && a.y == b.y && a.key == b.key && a.name == b.name;
}
bool near(const Named& a, const Named& b, double tolerance) {
  return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance && a.key == b.key && a.name == b.name;
}

using Row = Sequence<Named>;
using Pool = NodePool<Named>;
constexpr std::size_t leaf_size = Pool::leaf_size;

/// Item i of the rows below where all that counts is which one it is.
Named numbered(int i) { return {1.0 * i, -2.0 * i, 100.0 + i, i}; }

Row row_of(Pool& pool, int count, int first = 0) {
  Row row(pool);
  for (int i = first; i < first + count; ++i) row.append(Row(pool, numbered(i)));
  return row;
}

std::vector<Named> items_of(const Row& row) {
  std::vector<Named> items;
  row.for_each([&](const Named& item) { items.push_back(item); });
  return items;
}

std::vector<int> names_of(const Row& row) {
  std::vector<int> names;
  row.for_each([&](const Named& item) { names.push_back(item.name); });
  return names;
}

std::vector<int> names_from(int first, int count) {
  std::vector<int> names(static_cast<std::size_t>(count));
  std::iota(names.begin(), names.end(), first);
  return names;
}

/// Nodes that `action` makes.
template <class Action>
std::size_t made_by(const Pool& pool, Action&& action) {
  const std::uint64_t before = pool.nodes_made();
  action();
  return pool.nodes_made() - before;
}

/// Inner nodes above item i: to change an item of a copy makes all nodes on the way to it anew.
std::size_t depth_of(const Pool& pool, const Row& row, std::size_t i) {
  Row copy = row;
  return made_by(pool, [&] { copy.set_key(i, 0); }) - 1;
}

struct Shape {
  std::size_t leaves = 0, height = 0;
  bool balanced = true;
};

/// The tree of a row. When the items of a copy are changed in order, the first one of a leaf makes the nodes that the
/// ways before it have not made: those of a subtree down along its left side, to the leaf.
Shape shape_of(const Pool& pool, const Row& row) {
  Row copy = row;
  std::vector<std::size_t> left_sides;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (const std::size_t made = made_by(pool, [&] { copy.set_key(i, 0); })) left_sides.push_back(made);
  Shape shape;
  const auto height_of_next = [&](const auto& self) -> std::size_t {
    std::size_t height = 0;
    for (std::size_t above = left_sides[shape.leaves++] - 1; above > 0; --above) {
      const std::size_t right = self(self);
      if (right > height + 1 || height > right + 1) shape.balanced = false;
      height = 1 + std::max(height, right);
    }
    return height;
  };
  if (!left_sides.empty()) shape.height = height_of_next(height_of_next);
  EXPECT_EQ(shape.leaves, left_sides.size());
  return shape;
}

std::size_t full_leaves(std::size_t items) { return (items + leaf_size - 1) / leaf_size; }

Motion turned(double angle, double x, double y) { return {std::cos(angle), std::sin(angle), x, y}; }
Motion any_motion(Random& random) {
  return turned(random.uniform(0, 2 * std::numbers::pi), random.uniform(-1, 1), random.uniform(-1, 1));
}
/// Whole numbers: all arithmetic on them is exact.
Motion quarter_turns(Random& random) {
  const std::array<std::pair<double, double>, 4> turns{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto [cosine, sine] = turns[random.below(4)];
  return {cosine, sine, static_cast<double>(random.below(9)) - 4, static_cast<double>(random.below(9)) - 4};
}

// ---- Motion

void expect_place(const std::pair<double, double>& place, double x, double y, double tolerance) {
  EXPECT_NEAR(place.first, x, tolerance);
  EXPECT_NEAR(place.second, y, tolerance);
}

TEST(SchreiberMotion, TurnsThenShifts) {
  const Motion quarter{0, 1, 10, 20};
  EXPECT_EQ(quarter.turn(1, 2), std::pair(-2.0, 1.0));
  EXPECT_EQ(quarter.turn_back(-2, 1), std::pair(1.0, 2.0));
  EXPECT_EQ(quarter(1, 2), std::pair(8.0, 21.0));
  EXPECT_EQ(Motion()(1, 2), std::pair(1.0, 2.0));
}

TEST(SchreiberMotion, AProductIsTheRightOneThenTheLeftOne) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Motion a = any_motion(random), b = any_motion(random), c = any_motion(random);
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const auto [cx, cy] = c(x, y);
    const auto [bx, by] = b(cx, cy);
    const auto [ax, ay] = a(bx, by);
    // No number is above 6, and a few roundings make each.
    expect_place((a * b * c)(x, y), ax, ay, 100 * epsilon);
    expect_place((a * (b * c))(x, y), ax, ay, 100 * epsilon);
  }
}

TEST(SchreiberMotion, TheInverseUndoesItFromBothSides) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Motion motion = any_motion(random);
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const auto [mx, my] = motion(x, y);
    expect_place(motion.inverse()(mx, my), x, y, 50 * epsilon);
    expect_place((motion.inverse() * motion)(x, y), x, y, 50 * epsilon);
    expect_place((motion * motion.inverse())(x, y), x, y, 50 * epsilon);
    const auto [tx, ty] = motion.turn(x, y);
    expect_place(motion.turn_back(tx, ty), x, y, 50 * epsilon);
  }
}

TEST(SchreiberMotion, StaysRigidInAMillionProducts) {
  Random random(3);
  Motion from_left, from_right;
  for (int i = 0; i < 1000000; ++i) {
    const Motion next = any_motion(random);
    from_left = next * from_left, from_right = from_right * next;
    for (const Motion& motion : {from_left, from_right})
      ASSERT_NEAR(std::hypot(motion.cosine, motion.sine), 1, 4 * epsilon) << "after " << i;
  }
}

TEST(SchreiberMotion, ComesBackAfterAMillionStepsAlongACircle) {
  constexpr int steps = 1000000;
  // About the point (1, 0), which stays; a step rounds the angle by two epsilon at most and numbers up to 2 a few
  // times.
  const double angle = 2 * std::numbers::pi / steps;
  const Motion step = turned(angle, 1 - std::cos(angle), -std::sin(angle));
  Motion motion;
  for (int i = 0; i < steps; ++i) motion = step * motion;
  expect_place(motion(1, 0), 1, 0, 10 * steps * epsilon);
  expect_place(motion(0, 0), 0, 0, 10 * steps * epsilon);
}

TEST(SchreiberMotion, ARotationOfTheWrongLengthIsBroughtBack) {
  Motion motion = turned(0.5, 0, 0);
  motion.cosine *= 1.001, motion.sine *= 1.001;
  for (int i = 0; i < 3; ++i) motion = motion * Motion();
  EXPECT_NEAR(std::hypot(motion.cosine, motion.sine), 1, 4 * epsilon);
  EXPECT_NEAR(std::atan2(motion.sine, motion.cosine), 0.5, 4 * epsilon);
}

// ---- Sequence, one thing at a time

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

// ---- Everything at random, beside arrays

struct Beside {
  Row row;
  std::vector<Named> expected;
};

/// Random operations on a few rows and on arrays that should hold the same. Some copies are kept for the end.
class RandomRows {
 public:
  RandomRows(std::uint64_t seed, bool exact) : random_(seed), exact_(exact) {
    for (Beside& each : rows_) each.row = Row(pool_);
  }

  void step() {
    ++steps_;
    Beside& one = rows_[random_.below(rows_.size())];
    Beside& other = rows_[random_.below(rows_.size())];
    if (one.expected.size() > most) return cut(one, most / 2, other);
    const double share = random_.uniform();
    if (share < 0.08) {
      add_new(one);
    } else if (share < 0.26) {
      append(one, other);
    } else if (share < 0.32) {
      cut(one, random_.below(one.expected.size() + 3), other);
    } else if (share < 0.36) {
      cut(one, 0, one);  // what it holds goes out and comes back
    } else if (share < 0.56) {
      move(one);
    } else if (share < 0.60) {
      other = one;
    } else if (share < 0.64) {
      keep(one);
    } else if (!one.expected.empty()) {
      change(one, random_.below(one.expected.size()), share);
    }
    last_ = &one;
  }

  void check() {
    const bool all = steps_ % 10 == 0;
    for (const Beside& each : rows_)
      if (all || &each == last_) check(each, all);
  }

  void check_kept() const {
    for (const auto& [row, seen] : kept_) {
      ASSERT_EQ(items_of(row), seen) << "a copy was changed";
      check_least(row, seen);
    }
  }

  std::size_t longest() const { return longest_; }

  /// Lets go of everything; what the pool still holds.
  std::size_t bytes_left() {
    kept_.clear();
    for (Beside& each : rows_) each.row = Row();
    return pool_.bytes_in_use();
  }

 private:
  static constexpr std::size_t most = 12000;

  double key() { return random_.below(10) == 0 ? Row::none : static_cast<double>(random_.below(1000)); }
  Named item() {
    const double x = static_cast<double>(random_.below(21)) - 10, y = static_cast<double>(random_.below(21)) - 10;
    return {x, y, key(), next_name_++};
  }

  /// No place or frame is further from another than `reach_`, since each row began at the origin and every motion of
  /// the run took it away by its shift at most. On the way to an item are 18 motions at most, as the tree is no higher
  /// than 17 below 6765 leaves, and a step makes each of them anew from up to three. Every product, and every item
  /// moved, is wrong by up to eight roundings of numbers up to `reach_`.
  double tolerance() const { return exact_ ? 0 : 8 * epsilon * reach_ * 18 * (3 * steps_ + 1); }

  void add_new(Beside& one) {
    for (std::size_t n = random_.below(3) ? 1 + random_.below(5) : random_.below(400); n > 0; --n) {
      const Named next = item();
      one.row.append(Row(pool_, next));
      one.expected.push_back(next);
    }
  }

  void append(Beside& one, Beside& other) {
    const std::vector<Named> more = other.expected;  // they may be the same
    if (&one == &other || random_.below(2)) {
      one.row.append(other.row);
    } else {
      one.row.append(std::move(other.row));
      other.expected.clear();
    }
    one.expected.insert(one.expected.end(), more.begin(), more.end());
  }

  void cut(Beside& one, std::size_t i, Beside& other) {
    Beside rest{one.row.split(i), {}};
    i = std::min(i, one.expected.size());
    const auto middle = one.expected.begin() + static_cast<std::ptrdiff_t>(i);
    rest.expected.assign(middle, one.expected.end());
    one.expected.erase(middle, one.expected.end());
    check(one, false);
    other = std::move(rest);
  }

  void move(Beside& one) {
    const Motion motion = exact_ ? quarter_turns(random_) : any_motion(random_);
    reach_ += 2 * std::hypot(motion.x, motion.y);
    one.row.move(motion);
    for (Named& each : one.expected) each = each.moved(motion);
  }

  void keep(const Beside& one) {
    if (kept_.size() == 40) std::swap(kept_[random_.below(40)], kept_.back()), kept_.pop_back();
    kept_.emplace_back(one.row, items_of(one.row));
  }

  void change(Beside& one, std::size_t i, double share) {
    Named& expected = one.expected[i];
    if (share < 0.76) {
      one.row.erase(i);
      one.expected.erase(one.expected.begin() + static_cast<std::ptrdiff_t>(i));
    } else if (share < 0.88) {
      expected.key = key();
      one.row.set_key(i, expected.key);
    } else {
      one.row.update(i, [&](Named& stored, const Motion& to_frame) {
        EXPECT_TRUE(near(stored.moved(to_frame), expected, tolerance()));
        const double kept_key = expected.key;
        expected = item();
        expected.key = kept_key;
        stored = expected.moved(to_frame.inverse());
      });
    }
  }

  static void check_least(const Row& row, const std::vector<Named>& expected) {
    double least = Row::none;
    for (const Named& each : expected) least = std::min(least, each.key);
    ASSERT_EQ(row.least_key(), least);
  }

  void check(const Beside& each, bool all) {
    const auto& [row, expected] = each;
    longest_ = std::max(longest_, expected.size());
    ASSERT_EQ(row.size(), expected.size());
    ASSERT_EQ(row.empty(), expected.empty());
    if (expected.size() <= 1 || expected.size() > leaf_size) {
      ASSERT_EQ(row.is_flat(), expected.size() <= 1);
    }
    check_least(row, expected);
    for (int i = 0; i < 4; ++i) {
      const double limit = key() / 10;  // few are at most that
      const std::size_t from = random_.below(expected.size() + 3), begin = std::min(from, expected.size());
      const auto found = std::find_if(expected.begin() + static_cast<std::ptrdiff_t>(begin), expected.end(),
                                      [&](const Named& item) { return item.key <= limit; });
      ASSERT_EQ(row.first_key_at_most(limit, from), static_cast<std::size_t>(found - expected.begin()));
    }
    if (expected.empty()) return;
    ASSERT_TRUE(near(row.front(), expected.front(), tolerance()));
    ASSERT_TRUE(near(row.back(), expected.back(), tolerance()));
    const std::size_t i = random_.below(expected.size());
    ASSERT_TRUE(near(row[i], expected[i], tolerance())) << i;
    if (!all) return;
    const std::vector<Named> items = items_of(row);
    ASSERT_EQ(items.size(), expected.size());
    for (std::size_t j = 0; j < items.size(); ++j) {
      ASSERT_TRUE(near(items[j], expected[j], tolerance())) << j;
      ASSERT_EQ(items[j], row[j]) << j;
    }
    ASSERT_TRUE(shape_of(pool_, row).balanced);
  }

  Pool pool_;
  Random random_;
  bool exact_;
  std::array<Beside, 4> rows_;
  std::vector<std::pair<Row, std::vector<Named>>> kept_;
  const Beside* last_ = nullptr;
  int next_name_ = 0;
  std::uint64_t steps_ = 0;
  double reach_ = 40;
  std::size_t longest_ = 0;
};

void expect_same_as_arrays(bool exact) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomRows rows(seed, exact);
    for (int step = 0; step < 1500; ++step) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " step " << step);
      rows.step();
      rows.check();
      if (step % 100 == 99) rows.check_kept();
      if (testing::Test::HasFailure()) return;
    }
    longest = std::max(longest, rows.longest());
    ASSERT_EQ(rows.bytes_left(), 0u) << "seed " << seed;
  }
  EXPECT_GT(longest, 2000u) << "the runs are of no use when all rows are short";
}

TEST(SchreiberSequence, AgreesWithArraysExactlyWhenMotionsAreExact) { expect_same_as_arrays(true); }

TEST(SchreiberSequence, AgreesWithArraysUpToRounding) { expect_same_as_arrays(false); }

}  // namespace
}  // namespace geodrome::schreiber
