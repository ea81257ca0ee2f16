// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <string>

namespace geodrome {

/// Appends the shortest text that reads back as the same number; "inf", "nan".
inline void append_number(std::string& text, double value) {
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

inline std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace geodrome
