// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "plugins/solver_chen_han/windows.hpp"
#include "tests/support/samples.hpp"

namespace geodrome::chen_han {

/// A window whose members all tell it from the others.
inline Window named(Index name) {
  const double n = name;
  return {n + 0.125, -n - 0.25, n + 0.375, n + 0.5, n + 0.625, name, name + 1};
}

inline bool same(const Window& a, const Window& b) {
  return a.x == b.x && a.y == b.y && a.sigma == b.sigma && a.low == b.low && a.high == b.high && a.origin == b.origin &&
         a.parent == b.parent;
}

inline void fill(const WindowArrays& windows, std::size_t count, Index first) {
  for (std::size_t i = 0; i < count; ++i) windows.set(i, named(first + static_cast<Index>(i)));
}

/// Whether the windows are those that `fill` wrote.
inline bool holds(const WindowArrays& windows, std::size_t count, Index first) {
  for (std::size_t i = 0; i < count; ++i)
    if (!same(windows.get(i), named(first + static_cast<Index>(i)))) return false;
  return true;
}

/// The sizes of a wavefront: many small blocks, few large ones.
inline std::size_t random_count(test::Random& random) { return 1 + random.below(random.below(20) == 0 ? 700 : 20); }

}  // namespace geodrome::chen_han
