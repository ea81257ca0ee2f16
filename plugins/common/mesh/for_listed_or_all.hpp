// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// Calls `visit(v)` for the vertices that are listed; for all `count` of them, in order, where most are: memory is read
/// several times as fast in order. So `visit` does no harm to one that is not listed.
template <class Visit>
void for_listed_or_all(const std::vector<Index>& listed, std::size_t count, Visit&& visit) {
  if (2 * listed.size() < count) {
    for (const Index v : listed) visit(v);
    return;
  }
  for (Index v = 0; v < count; ++v) visit(v);
}

}  // namespace geodrome
