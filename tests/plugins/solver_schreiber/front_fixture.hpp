// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/solver_schreiber/front.hpp"
#include "plugins/solver_schreiber/lifetime.hpp"
#include "tests/plugins/solver_schreiber/wavefronts.hpp"

/// What must hold of every front, and the fixture of tests of its operations.
namespace geodrome::schreiber::test {

inline std::vector<Generator> generators_of(const Front& front) {
  std::vector<Generator> all;
  front.for_each([&](const Generator& g) { all.push_back(g); });
  return all;
}
inline std::vector<double> places_of(const Front& front, double length) {
  std::vector<double> ends;
  front.for_each([&](const Generator& g) { ends.push_back(g.low(length)), ends.push_back(g.high(length)); });
  return ends;
}

/// The key of generator i between its neighbours, all moved.
inline double lifetime_of(const Front& front, std::size_t i, const Motion& motion) {
  Generator left, right;
  if (i > 0) left = front[i - 1].moved(motion);
  if (i + 1 < front.size()) right = front[i + 1].moved(motion);
  return lifetime(i > 0 ? &left : nullptr, front[i].moved(motion), i + 1 < front.size() ? &right : nullptr);
}
inline bool is_same_key(double a, double b) { return a == b || std::abs(a - b) <= 1e-7 * std::abs(b); }
/// Every key is what it was in the frame before, or is here.
inline void expect_keys(const Front& front, const Motion& back = {}) {
  for (std::size_t i = 0; i < front.size(); ++i) {
    const double here = lifetime_of(front, i, {}), before = lifetime_of(front, i, back);
    ASSERT_TRUE(is_same_key(front[i].key, here) || is_same_key(front[i].key, before))
        << i << " of " << front.size() << ": " << front[i].key << " instead of " << here << " or " << before;
  }
}

/// A generator that has been narrowed must not go on with the key of a ray that it lost.
inline void expect_no_key_too_large(const Front& front) {
  for (std::size_t i = 0; i < front.size(); ++i)
    ASSERT_LE(front[i].key, lifetime_of(front, i, {}) * (1 + 1e-12)) << i << " of " << front.size();
}

inline void expect_in_order(const Front& front, double length) {
  const std::vector<double> ends = places_of(front, length);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (i % 2 == 0) {
      ASSERT_LT(ends[i], ends[i + 1]) << i / 2 << " has nothing";
    } else {
      ASSERT_LE(ends[i], ends[i + 1] + 1e-13 * length) << i / 2 << " and the next one overlap";
    }
  }
}

class SchreiberFront : public testing::Test {
 protected:
  FrontPool pool_;
  FrontEditor editor_{pool_};
};

}  // namespace geodrome::schreiber::test
