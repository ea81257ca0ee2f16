// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "plugins/solver_chen_han/lanes.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// Cuts windows of one half-edge against each other, so that no part of a window that is not shortest there is carried
/// on. Windows in order are cut by the lemma of ordered neighbours alone (ordered_pair.hpp). "Ordered" means: in the
/// order in which their lines enter the face below; where intervals do not overlap, they then follow each other.
class Trimming {
 public:
  explicit Trimming(const Lanes& lanes) : lanes_(&lanes) {}

  /// Trims `count` >= 1 ordered windows that may overlap until they are disjoint and ascending, and drops what is left
  /// empty; returns how many remain. `breaks`, empty before, gets the positions before which a pair could not be put in
  /// order: the list is ordered between them only.
  std::size_t trim(const WindowArrays& windows, std::size_t count, std::vector<std::uint32_t>& breaks) {
    return lanes_->cut(windows, count).is_whole() ? count : finish(windows, count, breaks);
  }

  /// Merges two lists of disjoint, ascending windows of which nothing is known about how they enter: at every point of
  /// the half-edge the one that is nearer there stays. A window may come out in pieces. O(n + m).
  void merge(WindowList& list, const Span& other);

  /// Counts windows that were dropped elsewhere.
  void drop(std::size_t count) { dropped_ += count; }
  std::uint64_t dropped() const { return dropped_; }
  void reset() { dropped_ = 0; }
  std::size_t bytes() const { return merged_.bytes(); }

 private:
  std::size_t finish(const WindowArrays& windows, std::size_t count, std::vector<std::uint32_t>& breaks);

  const Lanes* lanes_;
  WindowList merged_;
  std::uint64_t dropped_ = 0;
};

}  // namespace geodrome::chen_han
