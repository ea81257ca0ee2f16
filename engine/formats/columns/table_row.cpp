// SPDX-License-Identifier: MIT
#include "engine/formats/columns/table_row.hpp"

#include <algorithm>

#include "engine/formats/parse_number.hpp"

namespace geodrome::input {
namespace {

constexpr std::string_view blanks_of_lines = " \t\v\f\r\n";

std::string_view without_blanks(std::string_view text) {
  const std::size_t start = std::min(text.find_first_not_of(blanks_of_lines), text.size());
  const std::size_t end = text.find_last_not_of(blanks_of_lines);
  return end == text.npos ? std::string_view{} : text.substr(start, end + 1 - start);
}

std::size_t find_outside_quotes(std::string_view line, char sought) {
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') inside = !inside;
    if (line[i] == sought && !inside) return i;
  }
  return line.npos;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields) {
  for (std::size_t at = line.find_first_not_of(blanks_of_lines); at < line.size();) {
    const std::size_t quote = line[at] == '"' ? line.find('"', at + 1) : line.npos;
    const std::size_t end = std::min(line.find_first_of(blanks_of_lines, quote == line.npos ? at : quote), line.size());
    fields.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks_of_lines, end);
  }
}

}  // namespace

Separator separator_of(std::string_view line) {
  if (find_outside_quotes(line, ';') != line.npos) return Separator::semicolon;
  return find_outside_quotes(line, ',') != line.npos ? Separator::comma : Separator::blanks;
}

void split_row(std::string_view line, Separator separator, std::vector<std::string_view>& fields) {
  fields.clear();
  if (separator == Separator::blanks) return split_at_blanks(line, fields);
  bool inside = false;
  std::size_t start = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') inside = !inside;
    if (line[i] != static_cast<char>(separator) || inside) continue;
    fields.push_back(without_blanks(line.substr(start, i - start)));
    start = i + 1;
  }
  fields.push_back(without_blanks(line.substr(start)));
}

std::string_view without_comment(std::string_view line) {
  std::size_t end = find_comment(line, '#');
  const auto is_quoted = [&] { return std::ranges::count(line.substr(0, end), '"') % 2 == 1; };
  while (end < line.size() && is_quoted()) {
    const std::size_t more = find_comment(line.substr(end + 1), '#');
    end = more == line.npos ? more : end + 1 + more;
  }
  return without_blanks(line.substr(0, end));
}

std::string_view unquoted(std::string_view field) {
  const bool quoted = field.size() >= 2 && (field.front() == '"' || field.front() == '\'') && field.back() == field[0];
  return quoted ? without_blanks(field.substr(1, field.size() - 2)) : field;
}

}  // namespace geodrome::input
