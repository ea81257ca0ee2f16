// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace geodrome {

/// The rows of a matrix that one run computes: all, a range, or every n-th. Ascending; rows count from 0. A value.
class RowSet {
 public:
  /// Rows 0 .. rows - 1.
  static RowSet all(std::uint64_t rows);
  /// Rows begin .. end - 1. Throws OptionError if end < begin.
  static RowSet range(std::uint64_t begin, std::uint64_t end);
  /// Rows part, part + parts, part + 2 parts, ... below `rows`: the parts 0 .. parts - 1 share all rows evenly, and
  /// neighbouring rows, which cost about as much, go to different parts. Throws OptionError if part >= parts.
  static RowSet part(std::uint64_t part, std::uint64_t parts, std::uint64_t rows);

  /// O(1).
  std::uint64_t size() const noexcept;
  /// The i-th row of the set. Precondition: i < size(). O(1).
  std::uint64_t operator[](std::uint64_t i) const noexcept { return first_ + i * stride_; }
  /// O(1).
  bool contains(std::uint64_t row) const noexcept;

 private:
  RowSet(std::uint64_t first, std::uint64_t end, std::uint64_t stride) : first_(first), end_(end), stride_(stride) {}

  std::uint64_t first_, end_, stride_;
};

}  // namespace geodrome
