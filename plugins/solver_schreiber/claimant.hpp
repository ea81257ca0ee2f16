// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver_schreiber/front.hpp"

namespace geodrome::schreiber {

/// Whose a point of the face is, of the generators of a front, some of which may have died before it. Whether the owner
/// has a ray to the point is not asked.
class Claimant {
 public:
  /// O(n). Precondition: the front is not empty.
  Claimant(const Front& front, double px, double py);

  std::size_t owner() const { return owner_; }
  std::size_t size() const { return generators_.size(); }
  const Generator& operator[](std::size_t i) const { return generators_[i]; }

 private:
  std::vector<Generator> generators_;
  std::size_t owner_ = 0;
};

/// The number of the generator that owns a point, by binary search. Precondition: none has died before it. O(log^2 n).
std::size_t owner_by_search(const Front& front, double px, double py);

/// The owner of a point, whatever died before it; only those with keys up to `until` can have. O(log^2 n) if none has,
/// O(n) otherwise.
Generator owner_at(const Front& front, double px, double py, double until);

}  // namespace geodrome::schreiber
