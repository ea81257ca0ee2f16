// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <span>
#include <string>
#include <string_view>

namespace geodrome {

/// The base64 of some bytes, with padding and without line breaks. Source: RFC 4648, section 4.
std::string base64(std::string_view bytes);

/// The base64 of numbers as little-endian bytes.
template <class Number>
std::string base64_of(std::span<const Number> values) {
  static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");
  return base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

}  // namespace geodrome
