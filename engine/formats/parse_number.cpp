// SPDX-License-Identifier: MIT
#include "engine/formats/parse_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

namespace geodrome::input {
namespace {

constexpr std::string_view windows_names[] = {"INF", "IND", "QNAN", "SNAN"};

// "1.#INF00", "-1.#IND", "1.#QNAN", "1.#SNAN0": the name after the mark, then digits of no meaning.
ParsedNumber parse_windows_number(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  constexpr std::string_view mark = "1.#";
  if (!word.starts_with(mark)) return {0, NumberFault::syntax};
  word.remove_prefix(mark.size());
  const std::string_view name = word.substr(0, word.find_first_of("0123456789"));
  if (word.substr(name.size()).find_first_not_of("0123456789eE+-") != word.npos) return {0, NumberFault::syntax};
  if (std::ranges::find(windows_names, name) == std::end(windows_names)) return {0, NumberFault::syntax};
  if (name != "INF") return {std::numeric_limits<double>::quiet_NaN()};
  return {negative ? -INFINITY : INFINITY};
}

// Too large or too small? The wider type tells; what it cannot hold either is told by the exponent's sign.
ParsedNumber parse_out_of_range(std::string_view digits) {
  long double wide = 0;
  const bool holds = std::from_chars(digits.data(), digits.data() + digits.size(), wide).ec == std::errc();
  const bool small = holds ? std::fabs(wide) < 1 : digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
  if (small) return {holds ? static_cast<double>(wide) : 0};
  return {digits.starts_with('-') ? -INFINITY : INFINITY, NumberFault::range};
}

}  // namespace

std::size_t find_comment(std::string_view line, char mark) {
  std::size_t at = line.find(mark);
  const auto is_in_number = [&] {
    const auto follows = [&](std::string_view name) { return line.substr(at + 1).starts_with(name); };
    return line.substr(0, at).ends_with("1.") && std::ranges::any_of(windows_names, follows);
  };
  while (at != line.npos && mark == '#' && is_in_number()) at = line.find(mark, at + 1);
  return at;
}

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

ParsedNumber parse_number(std::string_view word) {
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) return parse_out_of_range(digits);
  if (error == std::errc() && stop == end) return {value};
  return parse_windows_number(digits);
}

}  // namespace geodrome::input
