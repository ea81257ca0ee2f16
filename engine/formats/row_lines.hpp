// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/formats/line_reader.hpp"

namespace geodrome::input {

/// Keeps how the rows of a stream of numbers lie on its lines: what tells a stream that is broken from one whose lines
/// are only laid out in another way.
class RowLines {
 public:
  /// Precondition: `lines` stands at the first number of a row.
  void begin(const LineReader& lines) { line_ = lines.line(), starts_line_ = lines.at_line_start(); }
  void end(const LineReader& lines) {
    if (starts_line_ && lines.at_line_end()) return;
    if (shared_ == 0) shared_ = line_;
    if (torn_ == 0 && lines.line() != line_) torn_ = line_;
  }

  /// The line where the first row begins that shares a line with another; 0 if every row has its own.
  std::size_t shared() const noexcept { return shared_; }
  /// The line where the first row begins that shares a line and is not whole on it; 0 if there is none.
  std::size_t torn() const noexcept { return torn_; }

 private:
  std::size_t line_ = 0, shared_ = 0, torn_ = 0;
  bool starts_line_ = false;
};

}  // namespace geodrome::input
