// SPDX-License-Identifier: MIT
#include "engine/surface/selection.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>

#include "engine/formats/source_file.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/surface/place.hpp"

namespace geodrome {

namespace {

/// Barycentric coordinates may be off by as much as six printed digits leave; they are normalised to sum 1.
constexpr double barycentric_tolerance = 1e-9;

constexpr const char* entry_syntax = "write one a line: 'i', 'x y z' or 'face b0 b1 b2'";
constexpr const char* pair_syntax = "write 'i, j', 'x y z, i', 'face b0 b1 b2, x y z': two entries of a list";

/// What editors of Windows put before UTF-8.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

using Words = std::vector<std::string>;

double to_number(const std::string& word) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
    throw OptionError(input::quoted(word) + " is not a number");
  return value;
}

std::size_t to_index(const std::string& word, const char* what) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw OptionError(input::quoted(word) + " is not the index of a " + what, "indices are whole numbers from 0");
  return value;
}

PointEntry to_row(const std::string& word) { return {.index = to_index(word, "row")}; }

/// The same coordinates with sum 1 up to rounding.
std::array<double, 3> normalised(std::array<double, 3> b) {
  const double sum = std::accumulate(b.begin(), b.end(), 0.0);
  const bool sound = std::ranges::min(b) >= 0 && std::abs(sum - 1) <= barycentric_tolerance;
  if (!sound) throw OptionError("barycentric coordinates must be >= 0 with sum 1");
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

/// A line of a file of points, without comment.
PointEntry to_entry(const std::string& text) {
  const std::size_t plus = text.find(" +");
  TextInput stream(text.substr(0, plus));
  const Words words{std::istream_iterator<std::string>(stream), {}};
  PointEntry entry;
  if (words.size() == 1)
    entry = to_row(words[0]);
  else if (words.size() == 3)
    entry = {.kind = PointEntry::Kind::position,
             .numbers = {to_number(words[0]), to_number(words[1]), to_number(words[2])}};
  else if (words.size() == 4)
    entry = to_face_point(words);
  else
    throw OptionError("expected 'i', 'x y z' or 'face b0 b1 b2', each with an optional '+ start'");
  if (plus != std::string::npos) entry.start = to_start(text.substr(plus + 2));
  return entry;
}

PointEntry to_end_of_pair(const std::string& text) {
  TextInput stream(text);
  std::string written;
  std::size_t words = 0;
  for (std::string word; stream >> word; ++words) written.append(words > 0 ? " " : "").append(word);
  if (written.find(" +") != std::string::npos)
    throw OptionError(input::quoted(written) + " has a start distance, which pairs have not",
                      "leave out what follows ' +'");
  if (words != 1 && words != 3 && words != 4)
    throw OptionError(input::quoted(written) + " names no point", pair_syntax);
  PointEntry entry = to_entry(written);
  if (entry.kind != PointEntry::Kind::row) entry.label = written;
  return entry;
}

PairEntry to_pair(const std::string& text) {
  const std::size_t comma = text.find(',');
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
  for_each_line(lines, name, entry_syntax, [&](const std::string& text, std::uint32_t line) {
    PointEntry entry = to_entry(text);
    entry.line = line;
    if (entry.kind != PointEntry::Kind::row) entry.label = "@" + std::to_string(selection.entries.size());
    selection.entries.push_back(std::move(entry));
  });
  if (selection.entries.empty()) throw InputError(InputFault::empty, name + ": names no point", entry_syntax);
  return selection;
}

}  // namespace

bool Selection::has_starts() const {
  return std::ranges::any_of(entries, [](const PointEntry& entry) { return entry.start > 0; });
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
  for (std::string word; std::getline(list, word, ',');) selection.entries.push_back(to_row(word));
  if (selection.entries.empty()) throw OptionError("no point is named", "write 'all', '0,5,9' or '@FILE'");
  return selection;
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
