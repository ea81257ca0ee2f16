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
  bool continued = false;  ///< a backslash at the end of a line joins the next one, if that begins with a number (OBJ)
  bool across = false;     ///< a number that is asked for may stand on a later line (PLY, OFF)
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
  /// Number of bytes after what was read.
  std::size_t bytes_left() const noexcept { return text_.size() - position_; }
  /// Goes to the next word, on a later line if need be; false at the end of the file.
  bool seek();
  /// The next word is the first of its line.
  bool at_line_start() const noexcept { return position_ == first_; }
  /// No word is left on the current line.
  bool at_line_end() const;
  /// The current line ends in a backslash that joins nothing to it.
  bool ends_in_backslash() const noexcept { return backslash_; }
  void go_across(bool across) noexcept { style_.across = across; }
  /// No word follows the current line.
  bool is_last() const;

  /// The next word of the line; empty at its end.
  std::string_view word();
  /// What is left of the line, without blanks at its ends.
  std::string_view rest() const;
  /// The next word as a number (`parse_number`). Rejected as range where it is too large for double.
  double number();
  /// Passes over a number that nobody uses, however large.
  void unused_number();
  /// The next word as an integer; beyond 64 bits the nearest that has 64.
  long long integer();
  /// The next three words as numbers.
  Vec3 point();
  /// Passes over what is left of the line, which must be numbers; returns how many they were.
  std::size_t further_numbers();

  [[noreturn]] void reject(InputFault fault, const std::string& what, Remedy remedy = {}) const;
  /// Rejects a line that ends too early: truncated if it is the last one, a syntax error otherwise.
  [[noreturn]] void reject_short(const std::string& what) const;

 private:
  std::string_view required_word();
  bool joins_next_line();
  bool is_joint(std::size_t i) const;
  std::size_t after_blanks() const;

  const SourceFile& file_;
  LineStyle style_;
  std::string_view text_;
  std::size_t next_;                    // where the next line starts
  std::size_t line_, line_after_;       // numbers of this line and the next one
  std::size_t position_ = 0, end_ = 0;  // what is left of the current line
  std::size_t first_ = 0;               // where its first word begins
  bool backslash_ = false;
};

/// The first word of a text whose comments begin with '#'; empty if there is none.
std::string_view first_word(const SourceFile& file);

}  // namespace geodrome::input
