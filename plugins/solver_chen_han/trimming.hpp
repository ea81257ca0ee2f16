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
  void use(const Lanes& lanes) { lanes_ = &lanes; }

  /// Trims `count` >= 1 ordered windows that may overlap until they are disjoint and ascending, and drops what is left
  /// empty; returns how many remain. `breaks` gets the positions before which a pair could not be put in order: the
  /// list is ordered between them only. The arrays are padded.
  std::size_t trim(const WindowArrays& windows, std::size_t count, std::vector<std::uint32_t>& breaks);

  /// Appends the ordered, disjoint windows of `right`, which enter to the right of all those of `list`, and trims at
  /// the seam. False, and nothing of `right` taken, if they cannot be put in order; what `list` lost is not needed.
  bool append(WindowList& list, const WindowArrays& right, std::size_t count);

  /// Merges two lists of disjoint, ascending windows of which nothing is known about how they enter: at every point of
  /// the half-edge the one that is nearer there stays. A window may come out in pieces. O(n + m).
  void merge(WindowList& list, const WindowArrays& other, std::size_t count);

  std::uint64_t dropped() const { return dropped_; }
  void reset() { dropped_ = 0; }
  std::size_t bytes() const { return cuts_.capacity() * sizeof(double) + merged_.bytes(); }

 private:
  std::size_t repair(const WindowArrays& windows, std::size_t count, std::vector<std::uint32_t>& breaks);

  const Lanes* lanes_;
  std::vector<double> cuts_;
  WindowList merged_;
  std::uint64_t dropped_ = 0;
};

}  // namespace geodrome::chen_han
