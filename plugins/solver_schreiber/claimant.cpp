// SPDX-License-Identifier: MIT
#include "solver_schreiber/claimant.hpp"

namespace geodrome::schreiber {
namespace {

/// Looks for the owner of a point: a generator that has the point on the right of its boundary with the one before and
/// on the left of that with the one behind. Where some died there can be several such; then what counts is which of
/// those has it from the others.
class OwnerSearch {
 public:
  OwnerSearch(const Front& front, double px, double py) : front_(front), px_(px), py_(py) {}

  /// Looks at generators [first, end) one by one.
  void walk(std::size_t first, std::size_t end) {
    bool is_right = first == 0 || right_of_boundary(first - 1);
    Generator rooms[2];
    const Generator* g = &front_.look(first, rooms[0]);
    for (std::size_t i = first; i < end; ++i) {
      const bool is_last = i + 1 == front_.size();
      const Generator* next = is_last ? g : &front_.look(i + 1, rooms[(i + 1 - first) % 2]);
      const bool goes_on = !is_last && right_has(*g, *next, px_, py_);
      if (is_right && !goes_on) add(i, *g);
      is_right = goes_on, g = next;
    }
  }
  /// The same by binary search, where all but the outermost live, so that their boundaries are in order.
  void search(std::size_t first, std::size_t end) {
    std::size_t low = first, high = end - 1;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (right_of_boundary(middle))
        low = middle + 1;
      else
        high = middle;
    }
    if (low == first && first > 0 && !right_of_boundary(first - 1)) return;
    if (low + 1 == end && end < front_.size() && right_of_boundary(low)) return;
    add(low, front_[low]);
  }

  std::size_t owner() const { return owner_; }

 private:
  bool right_of_boundary(std::size_t i) const {
    Generator left, right;
    return right_has(front_.look(i, left), front_.look(i + 1, right), px_, py_);
  }
  void add(std::size_t i, const Generator& g) {
    if (!found_ || right_has(best_, g, px_, py_)) owner_ = i, best_ = g;
    found_ = true;
  }

  const Front& front_;
  double px_, py_;
  std::size_t owner_ = 0;
  Generator best_{};
  bool found_ = false;
};

}  // namespace

std::size_t owner_of(const Front& front, double px, double py, double until) {
  OwnerSearch search(front, px, py);
  const std::size_t size = front.size();
  if (front.is_flat()) {
    search.walk(0, size);
    return search.owner();
  }
  for (std::size_t first = 0; first < size;) {
    const std::size_t suspect = front.first_key_at_most(until, first);
    if (first < suspect) search.search(first, suspect);
    if (suspect < size) search.walk(suspect, suspect + 1);
    first = suspect + 1;
  }
  return search.owner();
}

}  // namespace geodrome::schreiber
