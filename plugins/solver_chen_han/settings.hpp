// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "plugins/solver_chen_han/lanes.hpp"

namespace geodrome::chen_han {

/// How the searches of a plan (ManySearches) are run.
enum class Rows : std::uint8_t {
  automatic,  ///< by lists of direct paths if that takes less work, else plain
  plain,      ///< each by itself
  lists       ///< by lists of direct paths wherever that is possible
};

/// What the options of the plugin say.
struct Settings {
  bool filter = true;  ///< Xin and Wang's
  Simd simd = best_simd();
  Rows rows = Rows::automatic;
  std::size_t most_list_bytes = std::size_t{2048} << 20;
};

}  // namespace geodrome::chen_han
