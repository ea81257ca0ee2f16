// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "geodrome/engine/matrix_file.hpp"

namespace geodrome {

/// Bytes of one matrix entry.
constexpr std::uint64_t bytes_of(ScalarType scalar) { return scalar == ScalarType::float64 ? 8 : 4; }

/// The header of a .npy file, version 1.0, for a little-endian matrix in C order: magic, length, dictionary, padded
/// with spaces and a newline so that the first row starts at a multiple of 64 bytes. Source: numpy.lib.format, "NPY
/// format".
std::string npy_header(std::uint64_t rows, std::uint64_t columns, ScalarType scalar);

/// The same for a vector of `count` entries.
std::string npy_header(std::uint64_t count, ScalarType scalar);

}  // namespace geodrome
