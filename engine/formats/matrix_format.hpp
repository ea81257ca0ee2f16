// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "geodrome/engine/matrix_file.hpp"

namespace geodrome {

/// Bytes of one matrix entry.
constexpr std::uint64_t bytes_of(ScalarType scalar) { return scalar == ScalarType::float64 ? 8 : 4; }

/// Number of rows and columns of a matrix, and the type of its entries.
struct MatrixShape {
  std::uint64_t rows = 0, columns = 0;
  ScalarType scalar = ScalarType::float64;
};

/// A format of dense files: a header, then the rows one after the other without gaps, little-endian, in C order. Every
/// row has its place from the start, so that rows can be written in any order and a run that was interrupted can go on.
struct DenseFormat {
  /// The bytes before the first row.
  std::string (*header)(const MatrixShape& shape);
};

/// A format with a line of text for each row. Rows have no place before all others are known, so the text is made in
/// the end, from a whole dense file.
struct TextFormat {
  /// Appends one row, its end of line included.
  void (*append_row)(std::string& text, std::span<const double> values, ScalarType scalar);
  std::uint64_t most_bytes_per_entry;
  std::uint64_t most_entries;  ///< larger matrices are of no use as text
};

/// A format of matrices: the dense file in which they grow, and the text that it becomes if the format is one.
struct MatrixFormat {
  DenseFormat dense;
  const TextFormat* text = nullptr;  ///< null: the dense file is what was asked for
};

}  // namespace geodrome
