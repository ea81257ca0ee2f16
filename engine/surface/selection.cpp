// SPDX-License-Identifier: MIT
#include "engine/surface/selection.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

#include "engine/formats/source_file.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/surface/place.hpp"

namespace geodrome {

namespace {

/// Barycentric coordinates may be off by rounding: one below 0 is 0, then they are normalised to sum 1.
constexpr double barycentric_tolerance = 1e-9;

/// Whole numbers are exact in a double up to here.
constexpr double largest_whole = 0x1p53;

constexpr const char* entry_syntax = "write one a line: 'i', 'x y z' or 'face b0 b1 b2'";
constexpr const char* list_syntax = "write 'all', '0,5,9', '1-5', '0:100:10' or '@FILE'";
constexpr const char* pair_syntax = "write 'i, j', 'x y z, i', 'face b0 b1 b2, x y z': two entries of a list";
constexpr const char* range_syntax = "write 'a-b' (with b) or 'a:b' or 'a:b:step' (without b), a before b";

/// What editors of Windows put before UTF-8.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
  TextInput stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string with_blanks(const Words& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : " ").append(word);
  return text;
}

/// The whole text as a number of that type.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double to_number(const std::string& word) {
  const auto value = parsed<double>(std::string_view(word).substr(word.starts_with('+') ? 1 : 0));
  if (!value || !std::isfinite(*value)) throw OptionError(input::quoted(word) + " is not a number");
  if (std::abs(*value) > largest_number) throw OptionError(input::quoted(word) + " is beyond 1e100");
  return *value;
}

/// An index, as people write it or as numpy.savetxt does: 3.000000000000000000e+00.
std::size_t to_index(const std::string& word, const char* what) {
  if (const auto index = parsed<std::size_t>(word)) return *index;
  const auto number = parsed<double>(word);
  if (!number || !(*number >= 0 && *number <= largest_whole) || *number != std::floor(*number))
    throw OptionError(input::quoted(word) + " is not the index of a " + what,
                      "indices are whole numbers from 0; blanks separate the coordinates of a point");
  return static_cast<std::size_t>(*number);
}

/// The rows from `first` to before `end`.
PointEntry to_range(const std::string& word, std::size_t first, std::size_t end, std::size_t step) {
  if (first >= end || step == 0) throw OptionError("the range " + input::quoted(word) + " names no row", range_syntax);
  if (end > no_index)
    throw OptionError("the range " + input::quoted(word) + " ends beyond the last row that any input has",
                      "there are at most " + std::to_string(no_index));
  return {.index = first, .count = (end - first - 1) / step + 1, .step = step};
}

/// One row, or a range of rows: 'a-b' as people count, with b; 'a:b' and 'a:b:step' as numpy does, without b.
PointEntry to_rows(const std::string& word) {
  const std::string_view text = word;
  if (const std::size_t dash = text.find('-'); dash != text.npos) {
    const auto first = parsed<std::size_t>(text.substr(0, dash)), last = parsed<std::size_t>(text.substr(dash + 1));
    if (first && last) return to_range(word, *first, *last < no_index ? *last + 1 : std::size_t{no_index} + 1, 1);
  }
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return {.index = to_index(word, "row")};
  const std::size_t second = std::min(text.find(':', colon + 1), text.size());
  const auto first = parsed<std::size_t>(text.substr(0, colon)),
             end = parsed<std::size_t>(text.substr(colon + 1, second - colon - 1)),
             step =
                 second == text.size() ? std::optional<std::size_t>(1) : parsed<std::size_t>(text.substr(second + 1));
  if (!first || !end || !step) throw OptionError(input::quoted(word) + " is no range of rows", range_syntax);
  return to_range(word, *first, *end, *step);
}

/// The same coordinates, none below 0, with sum 1 up to rounding.
std::array<double, 3> normalised(std::array<double, 3> b) {
  double sum = std::accumulate(b.begin(), b.end(), 0.0);
  const bool sound = std::ranges::min(b) >= -barycentric_tolerance && std::abs(sum - 1) <= barycentric_tolerance;
  if (!sound) throw OptionError("barycentric coordinates must be >= 0 with sum 1");
  if (std::ranges::min(b) < 0) {
    for (double& coordinate : b) coordinate = std::max(coordinate, 0.0);
    sum = std::accumulate(b.begin(), b.end(), 0.0);
  }
  for (double& coordinate : b) coordinate /= sum;
  return b;
}

PointEntry to_face_point(const Words& words) {
  const std::size_t face = to_index(words[0], "face");
  return {.kind = PointEntry::Kind::on_face,
          .index = face,
          .numbers = normalised({to_number(words[1]), to_number(words[2]), to_number(words[3])})};
}

double to_start(const std::string& text) {
  std::string word, more;
  TextInput stream(text);
  stream >> word;
  const double value = word.empty() ? -1 : to_number(word);
  if (value < 0 || stream >> more) throw OptionError("a start distance is one number >= 0, not " + input::quoted(text));
  return value;
}

/// A line of a file of points, without comment, or what stands between two commas of a list.
PointEntry to_entry(const std::string& text) {
  const std::size_t plus = text.find(" +");
  const Words words = words_of(text.substr(0, plus));
  PointEntry entry;
  if (words.size() <= 1)
    entry = to_rows(words.empty() ? "" : words[0]);
  else if (words.size() == 3)
    entry = {.kind = PointEntry::Kind::position,
             .numbers = {to_number(words[0]), to_number(words[1]), to_number(words[2])}};
  else if (words.size() == 4)
    entry = to_face_point(words);
  else
    throw OptionError(input::quoted(with_blanks(words)) + " is neither 'i', 'x y z' nor 'face b0 b1 b2'",
                      "commas separate the entries of a list, lines those of a file");
  if (plus != std::string::npos) entry.start = to_start(text.substr(plus + 2));
  if (entry.kind != PointEntry::Kind::row) entry.label = with_blanks(words);
  return entry;
}

/// As `to_entry` for what stands on a line of a file.
PointEntry to_line(const std::string& text) {
  if (text.find(',') != text.npos)
    throw OptionError("there is a comma", "write an entry a line, and blanks between its numbers");
  return to_entry(text);
}

/// As `to_entry` for what stands between two commas. There 0 1 2 is not taken for a point: likely commas are forgotten.
PointEntry to_item(const std::string& text) {
  PointEntry entry = to_entry(text);
  const Words words = words_of(entry.label);
  const auto is_index = [](const std::string& word) { return parsed<std::size_t>(word).has_value(); };
  if (entry.kind == PointEntry::Kind::position && std::ranges::all_of(words, is_index))
    throw OptionError(input::quoted(entry.label) + " is three rows without commas, or a point",
                      "write rows as " + words[0] + "," + words[1] + "," + words[2] + ", and a point as " + words[0] +
                          ".0 " + words[1] + " " + words[2]);
  return entry;
}

PointEntry to_end_of_pair(const std::string& text) {
  const Words words = words_of(text);
  const std::string written = with_blanks(words);
  if (written.find(" +") != std::string::npos)
    throw OptionError(input::quoted(written) + " has a start distance, which pairs have not",
                      "leave out what follows ' +'");
  if (words.size() != 1 && words.size() != 3 && words.size() != 4)
    throw OptionError(input::quoted(written) + " names no point", pair_syntax);
  PointEntry entry = to_entry(written);
  if (entry.count != 1)
    throw OptionError(input::quoted(written) + " names " + std::to_string(entry.count) +
                          " rows, and a pair has one point at each end",
                      "write a pair a line");
  return entry;
}

/// Two entries with a comma between them; between two rows a blank is enough, as numpy.savetxt writes them.
PairEntry to_pair(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    const Words words = words_of(text);
    const auto is_number = [](const std::string& word) { return parsed<double>(word).has_value(); };
    if (words.size() == 2 && std::ranges::all_of(words, is_number))
      return {to_end_of_pair(words[0]), to_end_of_pair(words[1])};
  }
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    throw OptionError("expected two entries separated by one comma", pair_syntax);
  return {to_end_of_pair(text.substr(0, comma)), to_end_of_pair(text.substr(comma + 1))};
}

/// Calls `read(line, number)` for every line that holds more than a comment, without it. If that throws, names file and
/// line, and `syntax` as the remedy where there is none.
template <class Read>
void for_each_line(std::istream& file, const std::string& name, const char* syntax, Read&& read) {
  std::string text;
  for (std::uint32_t number = 1; std::getline(file, text); ++number) {
    if (number == 1 && text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    text = text.substr(0, text.find('#'));
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    for (char& c : text)
      if (c == '\t' || c == '\r') c = ' ';
    try {
      read(text, number);
    } catch (const OptionError& error) {
      throw InputError(InputFault::syntax, name + ": line " + std::to_string(number) + ": " + error.message(),
                       error.remedy().empty() ? Remedy(syntax) : error.coded_remedy());
    }
  }
}

Selection parse_file(const std::string& name) {
  if (name.empty())
    throw InputError(InputFault::io, "the list '@' names no file",
                     "write '@FILE' with the path of a file that may be read");
  TextInput lines(input::read_source(name).bytes);
  Selection selection{.file = name};
  std::uint64_t before = 0;
  for_each_line(lines, name, entry_syntax, [&](const std::string& text, std::uint32_t line) {
    PointEntry entry = to_line(text);
    entry.line = line;
    if (entry.kind != PointEntry::Kind::row) entry.label = "@" + std::to_string(before);
    before += entry.count;
    selection.entries.push_back(std::move(entry));
  });
  if (selection.entries.empty()) throw InputError(InputFault::empty, name + ": names no point", entry_syntax);
  return selection;
}

}  // namespace

bool Selection::has_starts() const {
  return std::ranges::any_of(entries, [](const PointEntry& entry) { return entry.start > 0; });
}

std::uint64_t Selection::count() const {
  std::uint64_t count = 0;
  for (const PointEntry& entry : entries) count += entry.count;
  return count;
}

NamedPoint point_on(const SurfaceMesh& mesh, const SurfacePoint& at, const std::string& label) {
  if (at.face >= mesh.face_count())
    throw OptionError(label + ": face " + std::to_string(at.face) + " does not exist",
                      "there are " + std::to_string(mesh.face_count()) + ", counted from 0");
  try {
    const SurfacePoint normal{at.face, normalised(at.b)};
    return {place_on(mesh, normal, mesh.position(normal)), 0, no_index, label};
  } catch (const OptionError& error) {
    throw OptionError(label + ": " + error.message());
  }
}

Selection parse_selection(const std::string& text) {
  if (text.starts_with('@')) return parse_file(text.substr(1));
  if (text == "all") return {.all = true};
  Selection selection;
  TextInput list(text + (text.ends_with(',') ? "," : ""));  // getline sees no empty word at the end
  for (std::string item; std::getline(list, item, ',');) selection.entries.push_back(to_item(item));
  if (selection.entries.empty()) throw OptionError("no point is named", list_syntax);
  return selection;
}

Selection parse_place(const std::string& text) {
  std::string numbers = text;
  std::ranges::replace(numbers, ',', ' ');
  const std::size_t words = words_of(numbers).size();
  if (text.starts_with('@') || (words != 3 && words != 4)) return parse_selection(text);
  return {.entries = {to_entry(numbers)}};
}

PairSelection parse_pairs(const std::filesystem::path& file) {
  input::SourceFile source = input::read_source(file);
  PairSelection selection{file.string(), {}, input::content_hash(source.bytes)};
  TextInput lines(std::move(source.bytes));
  for_each_line(lines, selection.file, pair_syntax, [&](const std::string& text, std::uint32_t line) {
    PairEntry& pair = selection.pairs.emplace_back(to_pair(text));
    pair.from.line = pair.to.line = line;
  });
  if (selection.pairs.empty()) throw InputError(InputFault::empty, selection.file + ": names no pair", pair_syntax);
  return selection;
}

}  // namespace geodrome
