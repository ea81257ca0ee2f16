// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_schreiber/front.hpp"

namespace geodrome::schreiber {

/// Returns the index of the generator that owns a point of the face: the one with the shortest straight path to it.
/// Some generators may have died before the point; those whose key exceeds `until` are known to be alive there. `until`
/// is the distance of the point and at least the length of the half-edge more: beside a gap a generator that still
/// lives may reach over its neighbour only farther on. Does not tell whether the owner has a ray to the point.
/// Precondition: the front is not empty. O(d log^2 n), where d - 1 generators can have died; O(n) for short fronts.
std::size_t owner_of(const Front& front, double px, double py, double until);

inline Generator owner_at(const Front& front, double px, double py, double until) {
  return front[owner_of(front, px, py, until)];
}

}  // namespace geodrome::schreiber
