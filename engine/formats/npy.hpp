// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "engine/formats/matrix_format.hpp"

namespace geodrome {

/// The header of a .npy file, version 1.0, for a little-endian matrix in C order: magic, length, dictionary, padded
/// with spaces and a newline so that the first row starts at a multiple of 64 bytes. Source: numpy.lib.format, "NPY
/// format".
std::string npy_header(std::uint64_t rows, std::uint64_t columns, ScalarType scalar);

/// The header of a .npy file, as above, for a vector of `count` entries.
std::string npy_header(std::uint64_t count, ScalarType scalar);

/// .npy as a format of dense files.
inline constexpr DenseFormat npy_dense{
    [](const MatrixShape& shape) { return npy_header(shape.rows, shape.columns, shape.scalar); }};

}  // namespace geodrome
