// SPDX-License-Identifier: MIT
#include "geodrome/engine/named_points.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>
#include <unordered_map>

#include "engine/formats/source_file.hpp"

namespace geodrome {

namespace {

/// Barycentric coordinates may be off by as much as six printed digits leave; they are normalised to sum 1.
constexpr double barycentric_tolerance = 1e-9;

constexpr const char* entry_syntax = "write one a line: 'i', 'x y z' or 'face b0 b1 b2'";
constexpr const char* pair_syntax = "write 'i, j', 'x y z, i', 'face b0 b1 b2, x y z': two entries of a list";

/// What editors of Windows put before UTF-8.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

double to_number(const std::string& word) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
    throw OptionError(input::quoted(word) + " is not a number");
  return value;
}

std::size_t to_index(const std::string& word, std::size_t count, const char* what) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw OptionError(input::quoted(word) + " is not the index of a " + what, "indices are whole numbers from 0");
  if (value >= count)
    throw OptionError(std::string(what) + " " + word + " does not exist",
                      "there are " + std::to_string(count) + ", counted from 0");
  return value;
}

/// Turns words into places; what it needs to know of input and surface is looked up once.
class Reader {
 public:
  Reader(const Input& input, const PlacedSurface& surface) : input_(input), surface_(surface), locator_(surface.locator) {}

  NamedPoint row(const std::string& word) const { return row(to_index(word, surface_.places.size(), "row")); }
  NamedPoint row(std::size_t i) const { return {surface_.places[i], 0, static_cast<Index>(i), std::to_string(i)}; }

  /// A line of a selection file, without comment; `entry` counts the entries.
  NamedPoint line(const std::string& text, std::size_t entry) {
    const std::size_t plus = text.find(" +");
    std::istringstream stream(text.substr(0, plus));
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    NamedPoint query;
    if (words.size() == 1)
      query = row(words[0]);
    else if (words.size() == 3)
      query.place = point(words);
    else if (words.size() == 4)
      query.place = on_face(words);
    else
      throw OptionError("expected 'i', 'x y z' or 'face b0 b1 b2', each with an optional '+ start'");
    if (query.row == no_index) query.label = "@" + std::to_string(entry);
    if (plus != std::string::npos) query.start = start(text.substr(plus + 2));
    return query;
  }

  /// A line of a file of pairs, without comment; `entry` counts the pairs.
  NamedPair pair(const std::string& text, std::size_t entry) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
      throw OptionError("expected two entries separated by one comma", pair_syntax);
    return {end_of_pair(text.substr(0, comma), entry), end_of_pair(text.substr(comma + 1), entry)};
  }

 private:
  NamedPoint end_of_pair(const std::string& text, std::size_t entry) {
    std::istringstream stream(text);
    std::string written;
    std::size_t words = 0;
    for (std::string word; stream >> word; ++words) written.append(words > 0 ? " " : "").append(word);
    if (written.find(" +") != std::string::npos)
      throw OptionError(input::quoted(written) + " has a start distance, which pairs have not",
                        "leave out what follows ' +'");
    if (words != 1 && words != 3 && words != 4)
      throw OptionError(input::quoted(written) + " names no point", pair_syntax);
    NamedPoint query = line(written, entry);
    if (query.row == no_index) query.label = written;
    return query;
  }

  static double start(const std::string& text) {
    std::string word, more;
    std::istringstream stream(text);
    stream >> word;
    const double value = word.empty() ? -1 : to_number(word);
    if (value < 0 || stream >> more)
      throw OptionError("a start distance is one number >= 0, not " + input::quoted(text));
    return value;
  }

  Place point(const std::vector<std::string>& words) {
    if (!locator_) locator_ = std::make_shared<const SurfaceLocator>(surface_.mesh);
    const Vec3 position{to_number(words[0]), to_number(words[1]), to_number(words[2])};
    const SurfacePoint at = locator_->closest(position).at;
    // On a mesh the surface itself was given, so the point meant is the one on it; a cloud's surface is an estimate.
    const bool estimated = surface_.made_from == InputKind::points;
    return {Place::State::on_surface, at, surface_.mesh->vertex_at(at),
            estimated ? position : surface_.mesh->position(at)};
  }

  Place on_face(const std::vector<std::string>& words) {
    if (surface_.made_from == InputKind::points)
      throw OptionError("a cloud has no faces", "name a row or a point 'x y z'");
    const std::size_t face = to_index(words[0], input_.facts.faces_in_file, "face");
    SurfacePoint at{triangle_of(static_cast<Index>(face)),
                    {to_number(words[1]), to_number(words[2]), to_number(words[3])}};
    const double sum = std::accumulate(at.b.begin(), at.b.end(), 0.0);
    if (std::min({at.b[0], at.b[1], at.b[2]}) < 0 || std::abs(sum - 1) > barycentric_tolerance)
      throw OptionError("barycentric coordinates must be >= 0 with sum 1");
    for (double& b : at.b) b /= sum;
    return {Place::State::on_surface, at, surface_.mesh->vertex_at(at), surface_.mesh->position(at)};
  }

  Index triangle_of(Index face) {
    if (triangles_of_face_.empty())
      for (Index t = 0; t < input_.face_of_triangle.size(); ++t)
        triangles_of_face_[input_.face_of_triangle[t]].push_back(t);
    const auto found = triangles_of_face_.find(face);
    if (found == triangles_of_face_.end())
      throw OptionError("face " + std::to_string(face) + " was dropped as degenerate");
    if (found->second.size() > 1)
      throw OptionError("face " + std::to_string(face) + " is no triangle", "name the point as 'x y z'");
    return found->second.front();
  }

  const Input& input_;
  const PlacedSurface& surface_;
  std::shared_ptr<const SurfaceLocator> locator_;
  std::unordered_map<Index, std::vector<Index>> triangles_of_face_;
};

/// Calls `read(line)` for every line that holds more than a comment, without it. If that throws, names file and line,
/// and `syntax` as the remedy where there is none.
template <class Read>
void for_each_line(std::istream& file, const std::string& name, const char* syntax, Read&& read) {
  std::string text;
  for (std::size_t number = 1; std::getline(file, text); ++number) {
    if (number == 1 && text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    text = text.substr(0, text.find('#'));
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    for (char& c : text)
      if (c == '\t' || c == '\r') c = ' ';
    try {
      read(text);
    } catch (const OptionError& error) {
      throw InputError(InputFault::syntax, name + ": line " + std::to_string(number) + ": " + error.message(),
                       error.remedy().empty() ? Remedy(syntax) : error.coded_remedy());
    }
  }
}

std::vector<NamedPoint> read_file(const std::string& name, Reader& reader) {
  std::error_code ignored;
  const bool is_directory = std::filesystem::is_directory(name, ignored);
  std::ifstream file(name);
  if (!file || is_directory)
    throw InputError(InputFault::io,
                     "the list '" + name + "' cannot be opened" + (is_directory ? ": it is a directory" : ""),
                     "write '@FILE' with the path of a file that may be read");
  std::vector<NamedPoint> queries;
  for_each_line(file, name, entry_syntax,
                [&](const std::string& text) { queries.push_back(reader.line(text, queries.size())); });
  if (queries.empty()) throw InputError(InputFault::empty, name + ": names no point", entry_syntax);
  return queries;
}

}  // namespace

std::vector<NamedPoint> select(const std::string& text, const Input& input, const PlacedSurface& surface) {
  Reader reader(input, surface);
  if (text.starts_with('@')) return read_file(text.substr(1), reader);
  std::vector<NamedPoint> queries;
  if (text == "all") {
    for (std::size_t i = 0; i < surface.places.size(); ++i) queries.push_back(reader.row(i));
    return queries;
  }
  std::istringstream list(text + (text.ends_with(',') ? "," : ""));  // getline sees no empty word at the end
  for (std::string word; std::getline(list, word, ',');) queries.push_back(reader.row(word));
  if (queries.empty()) throw OptionError("no point is named", "write 'all', '0,5,9' or '@FILE'");
  return queries;
}

PairList select_pairs(const std::filesystem::path& file, const Input& input, const PlacedSurface& surface) {
  Reader reader(input, surface);
  input::SourceFile source = input::read_source(file);
  PairList list{{}, input::content_hash(source.bytes)};
  std::istringstream lines(std::move(source.bytes));
  for_each_line(lines, file.string(), pair_syntax,
                [&](const std::string& text) { list.pairs.push_back(reader.pair(text, list.pairs.size())); });
  if (list.pairs.empty()) throw InputError(InputFault::empty, file.string() + ": names no pair", pair_syntax);
  return list;
}

}  // namespace geodrome
