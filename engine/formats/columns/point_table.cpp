// SPDX-License-Identifier: MIT
#include "engine/formats/columns/point_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "engine/formats/columns/column_choice.hpp"
#include "engine/formats/columns/table_row.hpp"
#include "engine/formats/line_reader.hpp"
#include "engine/formats/parse_number.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/formats/text.hpp"

namespace geodrome::input {
namespace {

constexpr const char* decimal_commas = "write decimal points in place of commas";

/// A number, or one if its commas were decimal points.
bool is_number_with_commas(std::string_view field) {
  std::string with_points(unquoted(field));
  std::ranges::replace(with_points, ',', '.');
  return parse_number(with_points).fault != NumberFault::syntax;
}

bool is_number(std::string_view field) { return parse_number(unquoted(field)).fault != NumberFault::syntax; }

std::optional<std::uint64_t> as_count(std::string_view field) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), count);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return count;
}

/// "1,5, 2,0, 3,0": every second comma has no blank after it, the others have one.
bool alternates_like_decimal_commas(std::string_view line) {
  std::size_t commas = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (line[i] != ',') continue;
    if ((line[i + 1] == ' ') != (commas % 2 == 1)) return false;
    ++commas;
  }
  return commas >= 5 && commas % 2 == 1;
}

class PointTable {
 public:
  PointTable(const SourceFile& file, std::string_view columns)
      : file_(file), lines_(file), choice_(file, parse_columns(columns)) {}

  Soup read() {
    while (lines_.next()) read_line(lines_.rest());
    check_count();
    check_first_column();
    return std::move(soup_);
  }

 private:
  bool before_points() const { return soup_.positions.empty(); }

  void read_line(std::string_view text) {
    const bool slashes = text.starts_with("//");
    if (slashes || text.starts_with('#')) {
      text.remove_prefix(std::min(text.find_first_not_of(slashes ? '/' : '#'), text.size()));
      if (before_points() && !text.empty()) choice_.add({text, lines_.line(), true});
      return;
    }
    text = without_comment(text);
    if (before_points() && read_preamble(text)) return;
    if (before_points()) start_points(text);
    read_point(text);
  }

  /// Reads what may stand before the points: their number, and the names of their columns.
  bool read_preamble(std::string_view text) {
    if (const auto count = as_count(text); count && !announced_) {
      announced_ = count;
      return true;
    }
    split_row(text, separator_of(text), fields_);
    if (named_line_ != 0 || std::ranges::any_of(fields_, is_number_with_commas)) return false;
    named_line_ = lines_.line();
    header_ = {text, named_line_, false};
    choice_.add(header_);
    return true;
  }

  /// Settles separator and columns by the first point.
  void start_points(std::string_view text) {
    separator_ = separator_of(text);
    split_row(text, separator_, fields_);
    if (named_line_ != 0) {
      std::vector<std::string_view> by_tabs;
      split_row(text, Separator::tab, by_tabs);
      const bool tabs = header_.names(fields_.size()).size() != fields_.size() &&
                        header_.names(by_tabs.size()).size() == by_tabs.size() && by_tabs.size() > 1;
      if (tabs) separator_ = Separator::tab, fields_ = by_tabs;
      // A separator at the end of each point.
      const std::size_t named = header_.names(fields_.size() - 1).size();
      if (named + 1 == fields_.size() && fields_.back().empty()) fields_.pop_back();
    }
    column_count_ = fields_.size();
    if (separator_ == Separator::comma && alternates_like_decimal_commas(text))
      lines_.reject(InputFault::unsupported, "the line looks as if commas were decimal points", decimal_commas);
    check_width();
    columns_ = choice_.choose(column_count_, soup_.findings);
  }

  void check_width() const {
    if (fields_.size() >= 3 && fields_.size() == column_count_) return;
    lines_.reject(InputFault::syntax,
                  "the line has " + std::to_string(fields_.size()) + " columns, " +
                      (column_count_ < 3 ? "a point needs three" : "the first has " + std::to_string(column_count_)));
  }

  void read_point(std::string_view text) {
    split_row(text, separator_, fields_);
    if (fields_.size() == column_count_ + 1 && separator_ != Separator::blanks && fields_.back().empty())
      fields_.pop_back();
    check_width();
    soup_.positions.push_back({number(columns_[0]), number(columns_[1]), number(columns_[2])});
    if (soup_.positions.size() >= no_index) lines_.reject(InputFault::unsupported, "more points than 32 bits count");
    if (choice_.is_made()) return;
    for (std::size_t i = 3; i < fields_.size(); ++i)
      if (!fields_[i].empty() && !is_number(fields_[i])) reject_field(fields_[i]);
    see_first_column(soup_.positions.back().x);
  }

  double number(std::size_t column) const {
    const std::string_view field = fields_[column];
    if (field.empty()) lines_.reject(InputFault::syntax, "column " + std::to_string(column + 1) + " is empty");
    const ParsedNumber number = parse_number(unquoted(field));
    if (number.fault == NumberFault::syntax) reject_field(field);
    if (number.fault == NumberFault::range)
      lines_.reject(InputFault::range, quoted(field) + " is too large for a double", "rescale the input");
    return number.value;
  }

  [[noreturn]] void reject_field(std::string_view field) const {
    const bool both = separator_ == Separator::comma && field.find_first_of(" \t") != field.npos;
    const std::string what = quoted(field) + " is no number";
    if (is_number_with_commas(field)) lines_.reject(InputFault::syntax, what, decimal_commas);
    if (both)
      lines_.reject(InputFault::syntax, what + ": commas and blanks both separate here",
                    "separate columns in one way, and write decimal points");
    lines_.reject(InputFault::syntax, what, column_count_ > 3 ? remedies::choose_columns("1,2,3") : Remedy());
  }

  void see_first_column(double x) {
    const std::size_t row = soup_.positions.size() - 1;
    if (row == 0) first_ = x, counts_ = std::floor(x) == x;
    counts_ = counts_ && x == first_ + static_cast<double>(row);
  }

  void check_count() const {
    const std::size_t found = soup_.positions.size();
    if (!announced_ || *announced_ == found) return;
    reject(
        file_, *announced_ > found ? InputFault::truncated : InputFault::syntax,
        "the first line announces " + std::to_string(*announced_) + " points, and " + std::to_string(found) + " follow",
        "write the number of points that there are, or none");
  }

  void check_first_column() {
    constexpr std::size_t least = 3;  // fewer may well be chance
    if (!counts_ || choice_.is_made() || soup_.positions.size() < least) return;
    const std::string what = "first column counts the lines, as indices do";
    const Remedy remedy = remedies::choose_columns(column_count_ > 3 ? "2,3,4 (or 1,2,3 if it is x)" : "1,2,3");
    if (column_count_ > 3)
      reject(file_, InputFault::unsupported,
             "the " + what + ", and there are " + std::to_string(column_count_) + " columns: is it x?", remedy);
    soup_.findings.push_back(
        {Finding::Severity::warning, "first_column_counts", "The " + what + "; it was taken for x.", 1, {}, remedy});
  }

  const SourceFile& file_;
  LineReader lines_;
  ColumnChoice choice_;
  Soup soup_;
  std::vector<std::string_view> fields_;
  Separator separator_ = Separator::blanks;
  std::size_t column_count_ = 0;
  Columns columns_{};
  std::optional<std::uint64_t> announced_;
  NameLine header_;
  std::size_t named_line_ = 0;  // of the names that are no comment
  double first_ = 0;
  bool counts_ = false;  // the first column, so far
};

}  // namespace

Soup read_point_table(const SourceFile& file, std::string_view columns) { return PointTable(file, columns).read(); }

}  // namespace geodrome::input
