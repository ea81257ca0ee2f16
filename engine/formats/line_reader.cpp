// SPDX-License-Identifier: MIT
#include "engine/formats/line_reader.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "engine/formats/parse_number.hpp"

namespace geodrome::input {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

// Where the blanks at the end of a text begin.
std::size_t end_of_words(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text.size();
}

}  // namespace

LineReader::LineReader(const SourceFile& file, LineStyle style, std::size_t offset, std::size_t lines_before)
    : file_(file), style_(style), text_(file.bytes), next_(offset), line_(lines_before), line_after_(lines_before + 1) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (offset == 0 && text_.substr(0, 3) == byte_order_mark) next_ = 3;
}

bool LineReader::next() {
  while (next_ < text_.size()) {
    position_ = next_, line_ = line_after_, backslash_ = false;
    bool joined = true;
    while (joined) {
      const std::size_t start = next_;
      end_ = std::min(text_.find_first_of("\r\n", start), text_.size());
      next_ = std::min(end_ + (text_.substr(end_, 2) == "\r\n" ? 2 : 1), text_.size());
      ++line_after_;
      const std::size_t comment =
          style_.comment ? find_comment(text_.substr(start, end_ - start), style_.comment) : text_.npos;
      if (comment != text_.npos) end_ = start + comment;  // a comment ends with its line, whatever it ends in
      joined = style_.continued && comment == text_.npos && joins_next_line();
    }
    while (position_ < end_ && is_blank(text_[position_])) ++position_;
    first_ = position_;
    if (position_ < end_) return true;
  }
  return false;
}

// Names end in a backslash too (folders of Windows), and no record begins with a number: so no record is ever
// swallowed.
bool LineReader::joins_next_line() {
  const std::size_t end = position_ + end_of_words(text_.substr(position_, end_ - position_));
  if (end == position_ || text_[end - 1] != '\\') return false;
  const std::size_t follows = text_.find_first_not_of(" \t\v\f", next_);
  constexpr std::string_view starts = "0123456789+-.";
  if (follows != text_.npos && starts.find(text_[follows]) != starts.npos) return true;
  backslash_ = true;
  if (text_.find_first_not_of(" \t\v\f\r\n", next_) == text_.npos) end_ = end - 1;  // nothing is left to be joined
  return false;
}

bool LineReader::seek() {
  position_ = after_blanks();
  return position_ < end_ || next();
}

bool LineReader::at_line_end() const { return after_blanks() == end_; }

std::string_view LineReader::rest() const {
  const std::string_view text = text_.substr(position_, end_ - position_);
  const std::size_t end = end_of_words(text), start = std::min(text.find_first_not_of(" \t\v\f\r\n"), end);
  return text.substr(start, end - start);
}

bool LineReader::is_last() const {
  LineReader rest = *this;
  return !rest.next();
}

std::size_t LineReader::after_blanks() const {
  std::size_t at = position_;
  while (at < end_ && (is_blank(text_[at]) || is_joint(at))) ++at;
  return at;
}

// A backslash at the end of a line that was joined.
bool LineReader::is_joint(std::size_t i) const {
  if (!style_.continued || text_[i] != '\\') return false;
  const std::size_t follows = std::min(text_.find_first_not_of(" \t\v\f", i + 1), end_);
  return follows < end_ && is_blank(text_[follows]);
}

std::string_view LineReader::word() {
  const std::size_t start = after_blanks();
  position_ = start;
  while (position_ < end_ && !is_blank(text_[position_]) && !is_joint(position_)) ++position_;
  return text_.substr(start, position_ - start);
}

std::string_view LineReader::required_word() {
  if (style_.across && !seek()) reject(InputFault::truncated, "the file ends where a number is expected");
  const std::string_view found = word();
  if (found.empty()) reject_short("the line ends where a number is expected");
  return found;
}

double LineReader::number() {
  const std::string_view found = required_word();
  const ParsedNumber number = parse_number(found);
  if (number.fault == NumberFault::syntax) reject(InputFault::syntax, quoted(found) + " is no number");
  if (number.fault == NumberFault::range)
    reject(InputFault::range, quoted(found) + " is too large for a double", "rescale the input");
  return number.value;
}

void LineReader::unused_number() {
  const std::string_view found = required_word();
  if (parse_number(found).fault == NumberFault::syntax) reject(InputFault::syntax, quoted(found) + " is no number");
}

long long LineReader::integer() {
  using Limits = std::numeric_limits<long long>;
  const std::string_view found = required_word(), digits = without_plus(found);
  const char* const end = digits.data() + digits.size();
  long long value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) return found[0] == '-' ? Limits::min() : Limits::max();
  if (error != std::errc() || stop != end) reject(InputFault::syntax, quoted(found) + " is no integer");
  return value;
}

Vec3 LineReader::point() {
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

std::size_t LineReader::further_numbers() {
  std::size_t count = 0;
  for (; !at_line_end(); ++count) unused_number();
  return count;
}

void LineReader::reject(InputFault fault, const std::string& what, Remedy remedy) const {
  input::reject(file_, fault, "line " + std::to_string(line_) + ": " + what, std::move(remedy));
}

void LineReader::reject_short(const std::string& what) const {
  reject(is_last() ? InputFault::truncated : InputFault::syntax, what);
}

std::string_view first_word(const SourceFile& file) {
  LineReader lines(file, {.comment = '#'});
  return lines.next() ? lines.word() : std::string_view{};
}

}  // namespace geodrome::input
