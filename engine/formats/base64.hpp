// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <boost/beast/core/detail/base64.hpp>
#include <span>
#include <string>

namespace geodrome {

/// The bytes of numbers, little-endian, as base64 with padding.
template <class Number>
std::string base64_of(std::span<const Number> values) {
  static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");
  namespace base64 = boost::beast::detail::base64;
  std::string text(base64::encoded_size(values.size_bytes()), '\0');
  text.resize(base64::encode(text.data(), values.data(), values.size_bytes()));
  return text;
}

}  // namespace geodrome
