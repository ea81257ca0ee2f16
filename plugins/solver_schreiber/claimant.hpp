// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_schreiber/front.hpp"

namespace geodrome::schreiber {

/// Whose a point of the face is, of the generators of a front, some of which may have died before it: only those with
/// keys up to `until` can have. `until` is the distance of the point and at least the length of the half-edge more: of
/// two that are beside a gap one that still lives may reach over the other only farther on. Whether the owner has a ray
/// to the point is not asked. Precondition: the front is not empty. O(d log^2 n), where d - 1 can have died; O(n) for
/// short fronts.
std::size_t owner_of(const Front& front, double px, double py, double until);

inline Generator owner_at(const Front& front, double px, double py, double until) {
  return front[owner_of(front, px, py, until)];
}

}  // namespace geodrome::schreiber
