// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>

#include "geodrome/errors.hpp"

namespace geodrome {

/// A number of a given byte order at `from`. Precondition: sizeof(Number) bytes are there.
template <class Number>
Number load(const char* from, std::endian order) {
  std::array<std::byte, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, sizeof(Number));
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// Appends a coordinate as a float of 32 bits. Throws InputError (range), naming `file` and what the floats are called,
/// for one that is too large.
inline void append_float32(std::string& bytes, double coordinate, const std::filesystem::path& file,
                           const char* floats) {
  if (std::abs(coordinate) > std::numeric_limits<float>::max())
    throw InputError(InputFault::range, file.string() + ": a coordinate does not fit into " + floats, "write PLY");
  append_little_endian(bytes, static_cast<float>(coordinate));
}

}  // namespace geodrome
