// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/common/exact/image_pair.hpp"
#include "plugins/solver_merged_windows/window.hpp"

namespace geodrome::merged_windows {

using Two = Register<2>;

/// Two windows of one half-edge in registers, the left one first.
struct Pair : ImagePair {
  Two low, high;

  Pair(const Window& left, const Window& right)
      : ImagePair(left, right), low(both(left.low, right.low)), high(both(left.high, right.high)) {}
};

}  // namespace geodrome::merged_windows
