// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "geodrome/engine/matrix_file.hpp"

namespace geodrome {

/// The most bytes that one entry of a .csv takes, with its comma or newline ("-2.2250738585072014e-308,").
inline constexpr std::uint64_t csv_bytes_per_entry = 25;

/// Appends one row to `text`: numbers separated by commas, then a newline. Each number is the shortest text that reads
/// back as the same `scalar` (at most 17 significant digits); unreachable is "inf", not computed is "nan". O(values).
void append_csv_row(std::string& text, std::span<const double> values, ScalarType scalar);

}  // namespace geodrome
