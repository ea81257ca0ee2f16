// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace geodrome::input {

enum class NumberFault {
  none,
  syntax,  ///< it is no number
  range    ///< it is too large for a double
};

struct ParsedNumber {
  double value = 0;
  NumberFault fault = NumberFault::none;
};

/// Where a comment begins that runs to the end of a line; npos if none does. The mark in 1.#IND and the like begins
/// none.
std::size_t find_comment(std::string_view line, char mark);

/// A word without its leading plus, which std::from_chars does not know.
std::string_view without_plus(std::string_view word);

/// The whole word as a number: decimal; nan, inf, infinity in any case; and what older libraries of Windows write for
/// these: 1.#QNAN, -1.#IND, 1.#INF, with digits after them or not. What is too small for double is 0.
ParsedNumber parse_number(std::string_view word);

}  // namespace geodrome::input
