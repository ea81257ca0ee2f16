// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/formats/source_file.hpp"
#include "geodrome/geometry.hpp"

namespace geodrome::input {

struct LineStyle {
  char comment = '\0';     ///< starts a comment that runs to the end of its line; '\0': there are none
  bool continued = false;  ///< a backslash at the end of a line joins the next one to it (OBJ)
};

/// Walks over a text: lines that hold something, and the words (between blanks) of each. Lines end with LF, CRLF or CR.
/// Whatever cannot be read as asked is rejected with the number of its line, from 1.
class LineReader {
 public:
  explicit LineReader(const SourceFile& file, LineStyle style = {}, std::size_t offset = 0,
                      std::size_t lines_before = 0);

  /// Goes to the next line that has a word; false at the end of the file.
  bool next();
  /// Number of the current line, from 1.
  std::size_t line() const noexcept { return line_; }
  /// Offset of the byte after the current line and its end.
  std::size_t offset() const noexcept { return next_; }
  /// No word follows the current line.
  bool is_last() const;

  /// The next word of the line; empty at its end.
  std::string_view word();
  /// The next word as a number: decimal, or nan, inf, infinity in any case. Numbers too small for double are 0.
  /// Rejected as range where it is too large for one.
  double number();
  /// The next word as an integer; beyond 64 bits the nearest that has 64.
  long long integer();
  /// The next three words as numbers.
  Vec3 point();
  /// Reads what is left of the line as numbers; returns how many they were.
  std::size_t further_numbers();

  [[noreturn]] void reject(InputFault fault, const std::string& what, Remedy remedy = {}) const;
  /// Rejects a line that ends too early: truncated if it is the last one, a syntax error otherwise.
  [[noreturn]] void reject_short(const std::string& what) const;

 private:
  std::string_view required_word();

  const SourceFile& file_;
  LineStyle style_;
  std::string_view text_;
  std::size_t next_;                    // where the next line starts
  std::size_t line_, line_after_;       // numbers of this line and the next one
  std::size_t position_ = 0, end_ = 0;  // what is left of the current line
};

/// The first word of a text whose comments begin with '#'; empty if there is none.
std::string_view first_word(const SourceFile& file);

}  // namespace geodrome::input
