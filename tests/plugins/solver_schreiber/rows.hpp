// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "plugins/solver_schreiber/sequence.hpp"
#include "tests/support/samples.hpp"

// Rows of items with names, for tests of motions and sequences.

namespace geodrome::schreiber::test {

using geodrome::test::Random;

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Named {
  double x, y, key;
  int name;

  Named moved(const Motion& motion) const {
    const auto [mx, my] = motion(x, y);
    return {mx, my, key, name};
  }
};
inline bool operator==(const Named& a, const Named& b) {
  return a.x == b.x && a.y == b.y && a.key == b.key && a.name == b.name;
}
inline bool near(const Named& a, const Named& b, double tolerance) {
  return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance && a.key == b.key && a.name == b.name;
}

using Row = Sequence<Named>;
using Pool = NodePool<Named>;
inline constexpr std::size_t leaf_size = Pool::leaf_size;

/// Item i of the rows below where all that counts is which one it is.
inline Named numbered(int i) { return {1.0 * i, -2.0 * i, 100.0 + i, i}; }

inline Row row_of(Pool& pool, int count, int first = 0) {
  Row row(pool);
  for (int i = first; i < first + count; ++i) row.append(Row(pool, numbered(i)));
  return row;
}

inline std::vector<Named> items_of(const Row& row) {
  std::vector<Named> items;
  row.for_each([&](const Named& item) { items.push_back(item); });
  return items;
}

inline std::vector<int> names_of(const Row& row) {
  std::vector<int> names;
  row.for_each([&](const Named& item) { names.push_back(item.name); });
  return names;
}

inline std::vector<int> names_from(int first, int count) {
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
inline std::size_t depth_of(const Pool& pool, const Row& row, std::size_t i) {
  Row copy = row;
  return made_by(pool, [&] { copy.set_key(i, 0); }) - 1;
}

struct Shape {
  std::size_t leaves = 0, height = 0;
  bool balanced = true;
};

/// The tree of a row. When the items of a copy are changed in order, the first one of a leaf makes the nodes that the
/// ways before it have not made: those of a subtree down along its left side, to the leaf.
inline Shape shape_of(const Pool& pool, const Row& row) {
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

inline std::size_t full_leaves(std::size_t items) { return (items + leaf_size - 1) / leaf_size; }

inline Motion turned(double angle, double x, double y) { return {std::cos(angle), std::sin(angle), x, y}; }
inline Motion any_motion(Random& random) {
  return turned(random.uniform(0, 2 * std::numbers::pi), random.uniform(-1, 1), random.uniform(-1, 1));
}
/// Whole numbers: all arithmetic on them is exact.
inline Motion quarter_turns(Random& random) {
  const std::array<std::pair<double, double>, 4> turns{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto [cosine, sine] = turns[random.below(4)];
  return {cosine, sine, static_cast<double>(random.below(9)) - 4, static_cast<double>(random.below(9)) - 4};
}

}  // namespace geodrome::schreiber::test
