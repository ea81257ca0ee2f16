// SPDX-License-Identifier: MIT
#include "solver_schreiber/claimant.hpp"

namespace geodrome::schreiber {

/// The point is on the right of the boundaries before its owner and on the left of those behind. One that has the point
/// on its left, as seen from its boundary with the generator before, and on its right, as seen from that behind, died.
Claimant::Claimant(const Front& front, double px, double py) {
  std::size_t place = 0;
  front.for_each([&](const Generator& g) {
    bool right = true;
    while (!alive_.empty()) {
      right = right_has(alive_.back().generator, g, px, py);
      if (!right || alive_.back().right_of_before) break;
      alive_.pop_back();
    }
    alive_.push_back({g, place++, alive_.empty() || right});
  });
  while (owner_ + 1 < alive_.size() && alive_[owner_ + 1].right_of_before) ++owner_;
}

std::size_t owner_by_search(const Front& front, double px, double py) {
  std::size_t low = 0, high = front.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (right_has(front[middle], front[middle + 1], px, py))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

Generator owner_at(const Front& front, double px, double py, double until) {
  if (front.is_flat() || front.least_key() <= until) return Claimant(front, px, py).generator();
  return front[owner_by_search(front, px, py)];
}

}  // namespace geodrome::schreiber
