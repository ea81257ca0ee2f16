// SPDX-License-Identifier: MIT
#pragma once

#include <locale>
#include <sstream>
#include <string>
#include <utility>

namespace geodrome {

/// Streams in memory that throw std::bad_alloc. Those of the standard library swallow it and are at their end then:
/// text would be cut off unnoticed where memory runs out. A locale that the program has set changes no number.
class TextInput : public std::istringstream {
 public:
  /// Precondition: begin <= text.size().
  explicit TextInput(std::string text, std::size_t begin = 0) : std::istringstream(std::move(text)) {
    exceptions(std::ios::badbit);
    imbue(std::locale::classic());
    seekg(static_cast<std::streamoff>(begin));
  }
};

class TextOutput : public std::ostringstream {
 public:
  explicit TextOutput(std::ios::openmode mode = std::ios::out) : std::ostringstream(mode) {
    exceptions(std::ios::badbit);
    imbue(std::locale::classic());
  }
};

}  // namespace geodrome
