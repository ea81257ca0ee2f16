// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/kept_windows.hpp"

#include <stdexcept>

namespace geodrome::merged_windows {

Index KeptWindows::add(const Window& window) {
  if (size_ >= way_bit) throw std::length_error("more windows than have numbers");
  if (size_ == pages_.size() * page_size) pages_.push_back(std::make_unique_for_overwrite<KeptWindow[]>(page_size));
  pages_[size_ / page_size][size_ % page_size] = {window.x,    window.y,     window.sigma,  window.low,
                                                  window.high, window.slack, window.origin, window.parent};
  return static_cast<Index>(size_++);
}

}  // namespace geodrome::merged_windows
