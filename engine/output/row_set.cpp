// SPDX-License-Identifier: MIT
#include "geodrome/engine/row_set.hpp"

#include <string>

#include "geodrome/errors.hpp"

namespace geodrome {

RowSet RowSet::all(std::uint64_t rows) { return {0, rows, 1}; }

RowSet RowSet::range(std::uint64_t begin, std::uint64_t end) {
  if (end < begin)
    throw OptionError(
        "the range of rows ends at " + std::to_string(end) + ", before it begins at " + std::to_string(begin),
        "name the first row, then the one after the last");
  return {begin, end, 1};
}

RowSet RowSet::part(std::uint64_t part, std::uint64_t parts, std::uint64_t rows) {
  if (part >= parts)
    throw OptionError("there is no part " + std::to_string(part) + " of " + std::to_string(parts),
                      "count the parts from 0");
  return {part, rows, parts};
}

std::uint64_t RowSet::size() const noexcept { return first_ < end_ ? (end_ - first_ - 1) / stride_ + 1 : 0; }

bool RowSet::contains(std::uint64_t row) const noexcept {
  return row >= first_ && row < end_ && (row - first_) % stride_ == 0;
}

}  // namespace geodrome
