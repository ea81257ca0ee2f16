// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/formats/soup.hpp"

namespace geodrome::input {

/// The columns of x, y and z, counted from 0.
using Columns = std::array<std::size_t, 3>;

/// Three columns as a user names them: "x,y,z", or by numbers from 1, "2,3,4". Throws OptionError for what is not three
/// different ones.
std::vector<std::string> parse_columns(std::string_view text);

/// A line before the points that may name their columns.
struct NameLine {
  std::string_view text;  ///< without what begins a comment
  std::size_t line = 0;
  bool is_comment = false;  ///< so it may also be something else

  /// Its words, split in the way that gives as many as `columns`; as they are split best, if none does.
  std::vector<std::string> names(std::size_t columns) const;
};

/// Where the columns of a table are chosen.
class ColumnChoice {
 public:
  /// `wanted`: of `parse_columns`; empty if the user chose none.
  ColumnChoice(const SourceFile& file, std::vector<std::string> wanted) : file_(file), wanted_(std::move(wanted)) {}

  void add(const NameLine& line) { lines_.push_back(line); }
  /// The columns of x, y and z among `count`: those that the user chose, else those of these names, else the first
  /// three. Throws OptionError for a choice that is not there, InputError for names that do not tell.
  Columns choose(std::size_t count, std::vector<Finding>& findings);
  /// True if the user or the file chose: then the other columns may hold anything.
  bool is_made() const noexcept { return made_; }

 private:
  Columns chosen(std::size_t count) const;
  std::size_t chosen_column(const std::string& wanted, std::size_t count) const;
  void check_names(const NameLine& line, std::size_t count) const;
  void tell_doubt(std::size_t count, std::vector<Finding>& findings) const;

  const SourceFile& file_;
  std::vector<std::string> wanted_;
  std::vector<NameLine> lines_;
  bool made_ = false;
};

}  // namespace geodrome::input
