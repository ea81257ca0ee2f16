// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/plugins/solver_schreiber/rows.hpp"

namespace geodrome::schreiber::test {
namespace {

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
        expected = item();
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
}  // namespace geodrome::schreiber::test
