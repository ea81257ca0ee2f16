// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "plugins/solver_chen_han/lanes.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// What of a list goes on through one edge of the face, and where it is clipped at the apex.
struct Child {
  Span list;
  Clip clip;
};

/// The lines to the left of the apex; the windows from `clipped` on also have lines to the apex, or beyond it.
inline Child to_left(const Span& list, std::size_t clipped) { return {list, {0, static_cast<int>(clipped)}}; }

/// The lines to the right of the apex; the first `clipped` windows also have lines to the apex, or beyond it.
inline Child to_right(const Span& list, std::ptrdiff_t clipped) {
  return {list, {static_cast<int>(clipped), static_cast<int>(list.count)}};
}

}  // namespace geodrome::chen_han
