// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_chen_han/lanes.hpp"

namespace geodrome::chen_han {

/// What the options of the plugin say.
struct Settings {
  bool filter = true;  ///< Xin and Wang's
  Simd simd = best_simd();
};

}  // namespace geodrome::chen_han
