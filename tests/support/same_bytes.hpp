// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <span>

namespace geodrome::test {

/// Bytes, not values: not even the sign of a zero may differ.
inline bool same_bytes(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace geodrome::test
