// SPDX-License-Identifier: MIT
#include "tests/fuzzing/target.hpp"

#include <algorithm>
#include <charconv>

namespace geodrome::fuzzing {
namespace {

constexpr std::size_t longest_message = 1000;

/// Lines end with LF, CRLF or CR; the last one may be empty.
std::size_t lines_of(std::string_view bytes) {
  return 1 + static_cast<std::size_t>(
                 std::count_if(bytes.begin(), bytes.end(), [](char c) { return c == '\n' || c == '\r'; }));
}

/// The number of the line that a message names behind the file; nothing if it names none. Only the place where the file
/// is named first counts: what is quoted from the file comes later, and may look the same.
std::optional<std::size_t> line_named(std::string_view message, std::string_view file) {
  const std::size_t at = file.empty() ? message.npos : message.find(file);
  if (at == message.npos) return std::nullopt;
  constexpr std::string_view word = ": line ";
  message.remove_prefix(at + file.size());
  if (!message.starts_with(word)) return std::nullopt;
  std::size_t line = 0;
  const char* const begin = message.data() + word.size();
  const auto [end, error] = std::from_chars(begin, message.data() + message.size(), line);
  demand(error == std::errc() && end != begin, "a message names a line by its number");
  return line;
}

}  // namespace

void demand_fit_to_show(const std::string& text) {
  demand(text.size() <= longest_message, "a message is short, whatever the file holds");
  for (const char c : text) demand(static_cast<unsigned char>(c) >= ' ' && c != '\x7F', "a message is printable");
}

void demand_clear(const Error& error, std::string_view file, std::string_view bytes) {
  demand(!error.message().empty(), "a refusal says why");
  demand_fit_to_show(error.what());
  demand(std::string_view(error.what()).find(file) != std::string_view::npos, "a refusal names the file");
  if (const auto line = line_named(error.message(), file))
    demand(*line >= 1 && *line <= lines_of(bytes), "a refusal names a line that is there");
}

std::string with_windows_line_ends(std::string_view text) {
  std::string result;
  for (const char c : text) result.append(c == '\n' ? "\r\n" : std::string(1, c));
  return result;
}

}  // namespace geodrome::fuzzing
