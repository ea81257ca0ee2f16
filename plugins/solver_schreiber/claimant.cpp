// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/claimant.hpp"

#include <vector>

#include "plugins/solver_schreiber/claims.hpp"

namespace geodrome::schreiber {
namespace {

/// Searches the owner of a point. The owner has the point on the right of its boundary with the generator before it and
/// on the left of that with the one behind it. A generator that has the point on the wrong side of both died before it,
/// and its neighbours meet.
class OwnerSearch {
 public:
  OwnerSearch(const Front& front, double px, double py) : front_(front), px_(px), py_(py) {}

  /// Returns the owner of the point among generators [first, end), which are alive, so that their boundaries are in
  /// order.
  std::size_t search(std::size_t first, std::size_t end) const {
    std::size_t low = first, high = end - 1;
    if (low < high && !has(low, low + 1))  // most often the point is outside
      high = low;
    else if (low < high && has(high - 1, high))
      low = high;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (has(middle, middle + 1))
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }

  /// Adds generators [first, end), of which `owner` has the point from the others. Runs are added in ascending order.
  void add(std::size_t first, std::size_t owner, std::size_t end) {
    while (!is_open_) {
      const std::size_t before = behind_.empty() ? owner_ : behind_.back().end - 1;
      if (!has(before, first)) {
        if (first == owner) break;
        first = owner;
      } else if (behind_.empty()) {
        is_open_ = true;
      } else if (--behind_.back().end == behind_.back().begin) {
        behind_.pop_back();
      }
    }
    if (is_open_) owner_ = owner++, is_open_ = false;
    if (owner == end) return;
    if (!behind_.empty() && behind_.back().end == owner)
      behind_.back().end = end;
    else
      behind_.push_back({owner, end});
  }

  std::size_t owner() const { return owner_; }

 private:
  struct Run {
    std::size_t begin, end;
  };
  /// Tells whether the point is on the right of the boundary between two generators.
  bool has(std::size_t left, std::size_t right) const {
    Generator rooms[2];
    return right_has(front_.look(left, rooms[0]), front_.look(right, rooms[1]), px_, py_);
  }

  const Front& front_;
  double px_, py_;
  std::size_t owner_ = 0;
  bool is_open_ = true;      ///< nobody owns the point yet
  std::vector<Run> behind_;  ///< what lives behind the owner
};

}  // namespace

std::size_t owner_of(const Front& front, double px, double py, double until) {
  OwnerSearch search(front, px, py);
  const std::size_t size = front.size();
  if (size <= short_front) {
    for (std::size_t i = 0; i < size; ++i) search.add(i, i, i + 1);
    return search.owner();
  }
  for (std::size_t first = 0; first < size;) {
    const std::size_t suspect = front.first_key_at_most(until, first);
    if (first < suspect) search.add(first, search.search(first, suspect), suspect);
    if (suspect < size) search.add(suspect, suspect, suspect + 1);
    first = suspect + 1;
  }
  return search.owner();
}

}  // namespace geodrome::schreiber
