// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace geodrome::fuzzing {

/// Changes an input as libFuzzer does, but the same on every platform: bytes flipped, inserted, cut out, copied from
/// elsewhere, numbers put in the place of digits.
inline std::string mutated(std::string input, std::mt19937_64& random) {
  const auto below = [&](std::size_t end) {
    return static_cast<std::size_t>(random() % std::max<std::size_t>(end, 1));
  };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(input.size()), length = std::min(input.size() - at, 1 + below(16));
    constexpr std::string_view words[] = {
        "-1",   "4294967296", "99999999999999999999", "nan", "inf", "1e308", "e-400", "\n", "\r\n", " ", "#", ",",
        "\\\n", "+"};
    switch (below(5)) {
      case 0:
        input.insert(at, 1, static_cast<char>(random()));
        break;
      case 1:
        input.erase(at, length);
        break;
      case 2:
        input.insert(below(input.size()), input.substr(at, length));
        break;
      case 3:
        input.replace(std::min(input.find_first_of("0123456789", at), input.size()), 1, words[below(std::size(words))]);
        break;
      default:
        if (!input.empty()) input[at] = static_cast<char>(random());
    }
  }
  return input;
}

/// A stretch of an input many times over: long lines and words, deep nesting, many columns or options.
inline std::string stretched(const std::string& input, std::mt19937_64& random) {
  constexpr std::size_t total = 100'000;
  const std::size_t at = random() % std::max<std::size_t>(input.size(), 1), length = 1 + random() % 8;
  const std::string piece = input.substr(at, length);
  if (piece.empty()) return input;
  std::string result = input.substr(0, at);
  for (std::size_t i = 0; i < total / piece.size(); ++i) result += piece;
  return result + input.substr(at);
}

}  // namespace geodrome::fuzzing
