// SPDX-License-Identifier: MIT
#include "engine/formats/line_reader.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace geodrome::input {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

// std::from_chars knows no leading plus.
std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

LineReader::LineReader(const SourceFile& file, LineStyle style, std::size_t offset, std::size_t lines_before)
    : file_(file), style_(style), text_(file.bytes), next_(offset), line_(lines_before), line_after_(lines_before + 1) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (offset == 0 && text_.substr(0, 3) == byte_order_mark) next_ = 3;
}

bool LineReader::next() {
  while (next_ < text_.size()) {
    position_ = next_, line_ = line_after_;
    for (std::size_t from = next_;;) {
      end_ = std::min(text_.find_first_of("\r\n", from), text_.size());
      const bool both = text_.substr(end_, 2) == "\r\n";
      next_ = std::min(end_ + (both ? 2 : 1), text_.size());
      ++line_after_;
      const bool joined = style_.continued && end_ > position_ && text_[end_ - 1] == '\\' && next_ < text_.size();
      if (!joined) break;
      from = next_;
    }
    const std::string_view line = text_.substr(position_, end_ - position_);
    if (style_.comment) end_ = position_ + std::min(line.size(), line.find(style_.comment));
    while (position_ < end_ && is_blank(text_[position_])) ++position_;
    if (position_ < end_) return true;
  }
  return false;
}

bool LineReader::is_last() const {
  LineReader rest = *this;
  return !rest.next();
}

std::string_view LineReader::word() {
  const auto separates = [&](std::size_t i) {
    const bool joint = style_.continued && text_[i] == '\\' && i + 1 < end_ && is_blank(text_[i + 1]);
    return joint || is_blank(text_[i]);
  };
  while (position_ < end_ && separates(position_)) ++position_;
  const std::size_t start = position_;
  while (position_ < end_ && !separates(position_)) ++position_;
  return text_.substr(start, position_ - start);
}

std::string_view LineReader::required_word() {
  const std::string_view found = word();
  if (found.empty()) reject_short("the line ends where a number is expected");
  return found;
}

double LineReader::number() {
  const std::string_view found = required_word(), digits = without_plus(found);
  const char* const end = digits.data() + digits.size();
  double value = 0;
  auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) {
    // Too large or too small? The wider type tells; what it cannot hold either is told by the exponent's sign.
    long double wide = 0;
    const bool holds = std::from_chars(digits.data(), end, wide).ec == std::errc();
    const bool small =
        holds ? std::fabs(wide) < 1 : digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
    if (!small) reject(InputFault::range, quoted(found) + " is too large for a double", "rescale the input");
    return holds ? static_cast<double>(wide) : 0;
  }
  if (error != std::errc() || stop != end) reject(InputFault::syntax, quoted(found) + " is no number");
  return value;
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
  while (true) {
    const std::size_t before = position_;
    if (word().empty()) return count;
    position_ = before;
    number();
    ++count;
  }
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
