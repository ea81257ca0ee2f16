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

/// A number of so many significant digits, without zeros at its end; 1e+06 where it has more digits than these.
inline std::string rounded_text(double value, int digits) {
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr};
}

}  // namespace geodrome
