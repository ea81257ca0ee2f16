// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <string>

namespace geodrome {

/// The shortest text that reads back as the same number; "inf", "nan".
inline std::string number_text(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

}  // namespace geodrome
