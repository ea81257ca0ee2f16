// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/kept_windows.hpp"

#include <stdexcept>

namespace geodrome::chen_han {

Index KeptWindows::keep(Index half_edge, const WindowArrays& windows, std::size_t count) {
  if (size_ + count >= no_index) throw std::length_error("more than 4 billion windows to keep");
  const auto first = static_cast<Index>(size_);
  passes_.push_back({half_edge, first, last_[half_edge]});
  last_[half_edge] = static_cast<Index>(passes_.size() - 1);
  for (std::size_t i = 0; i < count; ++i, ++size_) {
    if (size_ / page_size == pages_.size()) pages_.push_back(std::make_unique_for_overwrite<Window[]>(page_size));
    pages_[size_ / page_size][size_ % page_size] = windows.get(i);
  }
  return first;
}

}  // namespace geodrome::chen_han
