// SPDX-License-Identifier: MIT
#include "solver_schreiber/claimant.hpp"

namespace geodrome::schreiber {

/// The owner has the point on the right of its boundary with the one before and on the left of that with the one
/// behind. Where some died there can be several such; then what counts is which of those has it from the others.
Claimant::Claimant(const Front& front, double px, double py) {
  generators_.reserve(front.size());
  front.for_each([this](const Generator& g) { generators_.push_back(g); });
  std::size_t candidate = 0;
  bool first = true;
  for (std::size_t i = 0; i < generators_.size(); ++i) {
    const bool is_last = i + 1 == generators_.size();
    const bool goes_on = !is_last && right_has(generators_[i], generators_[i + 1], px, py);
    if (!goes_on && candidate == i) {
      if (first || right_has(generators_[owner_], generators_[i], px, py)) owner_ = i;
      first = false;
    }
    if (goes_on) candidate = i + 1;
  }
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
  if (front.is_flat() || front.least_key() <= until) {
    const Claimant all(front, px, py);
    return all[all.owner()];
  }
  return front[owner_by_search(front, px, py)];
}

}  // namespace geodrome::schreiber
