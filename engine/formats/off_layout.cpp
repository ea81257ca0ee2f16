// SPDX-License-Identifier: MIT
#include "engine/formats/off_layout.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "engine/formats/row_lines.hpp"

namespace geodrome::input {
namespace {

std::string prefix_of(std::string_view keyword) { return std::string(keyword.substr(0, keyword.find("OFF"))); }

class OffReader {
 public:
  OffReader(const SourceFile& file, const OffLayout& layout)
      : file_(file), layout_(layout), lines_(file, {.comment = '#', .across = true}) {}

  OffReading read() {
    read_counts();
    layout_.columns == 0 ? read_vertices_of_lines() : read_vertices();
    layout_.faces_on_lines ? read_faces_of_lines() : read_faces();
    reading_.complete = !lines_.seek();
    reading_.torn = rows_.torn();
    return std::move(reading_);
  }

 private:
  void read_counts();
  void read_vertices_of_lines();
  void read_vertices();
  void read_faces_of_lines();
  void read_faces();
  void read_corners(long long f, long long count);
  void check_colour(long long f, std::size_t line);
  void see_colour(std::size_t numbers, std::size_t line);
  long long glued_count(std::string_view keyword) const;
  long long read_count();
  void require(bool there, long long done, long long count, const char* elements) const;

  const SourceFile& file_;
  const OffLayout layout_;
  LineReader lines_;
  long long vertices_ = 0, faces_ = 0;
  RowLines rows_;
  OffReading reading_;
  unsigned lengths_ = 0;  // of colours: bit k for k numbers
};

void check_keyword(const LineReader& lines, std::string_view keyword) {
  if (keyword.find("OFF") == keyword.npos)
    lines.reject(InputFault::syntax, "the keyword OFF is missing, found " + quoted(keyword));
  if (prefix_of(keyword).find_first_of("4n") != std::string::npos)
    lines.reject(InputFault::unsupported, "vertices are not in three dimensions");
}

// "OFF490 518 0".
long long OffReader::glued_count(std::string_view keyword) const {
  long long count = 0;
  for (const char digit : keyword.substr(keyword.find("OFF") + 3)) {
    if (digit < '0' || digit > '9' || count > 99'999'999'999)
      lines_.reject(InputFault::syntax, quoted(keyword) + " is no keyword");
    count = 10 * count + (digit - '0');
  }
  return count;
}

long long OffReader::read_count() {
  const long long count = lines_.integer();
  if (count < 0) lines_.reject(InputFault::syntax, "a count is negative");
  return count;
}

void OffReader::read_counts() {
  if (!lines_.seek()) reject(file_, InputFault::empty, "the file holds nothing but blanks and comments");
  const std::string_view keyword = lines_.word();
  check_keyword(lines_, keyword);
  if (LineReader same_line = lines_; same_line.word() == "BINARY")
    lines_.reject(InputFault::unsupported, "binary OFF is not read", "convert it to PLY");
  if (!lines_.seek()) reject(file_, InputFault::truncated, "the file ends after its keyword");
  vertices_ = keyword.ends_with("OFF") ? read_count() : glued_count(keyword);
  faces_ = read_count();
  constexpr std::size_t vertex_bytes = 6, face_bytes = 2;  // "0 0 0\n" and "0\n"
  check_announced(file_, "vertices", vertices_, vertex_bytes, lines_.bytes_left());
  check_announced(file_, "faces", faces_, face_bytes, lines_.bytes_left());
  if (!lines_.at_line_end() && layout_.columns == 0)
    lines_.further_numbers();  // the number of edges, which nobody needs
  else if (!lines_.at_line_end() || layout_.edges_on_a_line)
    read_count();
  if (!lines_.at_line_end() && layout_.columns == 0)
    lines_.reject(InputFault::syntax, "the line goes on after the number of edges");
  reading_.soup.positions.reserve(vertices_);
  reading_.soup.face_end.reserve(faces_);
  reading_.soup.corners.reserve(3 * faces_);
}

void OffReader::require(bool there, long long done, long long count, const char* elements) const {
  if (there) return;
  reject(file_, InputFault::truncated,
         "the file ends after " + std::to_string(done) + " of " + std::to_string(count) + " " + elements);
}

void OffReader::read_vertices_of_lines() {
  lines_.go_across(false);
  std::size_t further = 0;  // normals, colours, texture
  for (long long v = 0; v < vertices_; ++v) {
    require(lines_.next(), v, vertices_, "vertices");
    reading_.soup.positions.push_back(lines_.point());
    const std::size_t found = lines_.further_numbers();
    if (v == 0) further = found;
    if (found != further)
      lines_.reject(InputFault::syntax, "the line has " + std::to_string(3 + found) +
                                            " numbers, the first vertex has " + std::to_string(3 + further));
  }
  lines_.go_across(true);
}

void OffReader::read_vertices() {
  for (long long v = 0; v < vertices_; ++v) {
    require(lines_.seek(), v, vertices_, "vertices");
    rows_.begin(lines_);
    reading_.soup.positions.push_back(lines_.point());
    for (std::size_t i = 3; i < layout_.columns; ++i) lines_.unused_number();
    rows_.end(lines_);
  }
}

void OffReader::read_corners(long long f, long long count) {
  Soup& soup = reading_.soup;
  for (long long i = 0; i < count; ++i)
    soup.corners.push_back(checked_corner(file_, f, lines_.integer(), soup.positions.size()));
  soup.face_end.push_back(soup.corners.size());
}

// On a line of its own a face may have a colour. Where it goes on to a second line, numbers that follow it there tell
// rather that a corner is missing.
void OffReader::check_colour(long long f, std::size_t line) {
  if (lines_.at_line_end()) return lines_.line() == line ? see_colour(0, line) : void();
  const std::string face = "line " + std::to_string(line) + ": face " + std::to_string(f);
  const char* const remedy = "give every face all its corners, and a line of its own";
  if (lines_.line() != line)
    reject(file_, InputFault::syntax,
           face + " goes on to line " + std::to_string(lines_.line()) + ", where more numbers follow it", remedy);
  const std::size_t numbers = lines_.further_numbers();
  if (numbers == 2 || numbers > 4)
    reject(file_, InputFault::syntax,
           face + " is followed by " + std::to_string(numbers) + " numbers, and a colour has 1, 3 or 4", remedy);
  reading_.coloured = true;
  see_colour(numbers, line);
}

// Some faces may well have no colour, but a colour that is a number shorter than others tells of a missing corner.
void OffReader::see_colour(std::size_t numbers, std::size_t line) {
  constexpr unsigned no_colour = 1, rgb = 1 << 3, rgba = 1 << 4;
  lengths_ |= 1u << numbers;
  const bool usual =
      (lengths_ & (lengths_ - 1)) == 0 || lengths_ == (no_colour | rgb) || lengths_ == (no_colour | rgba);
  if (!usual && reading_.mixed == 0) reading_.mixed = line;
}

void OffReader::read_faces_of_lines() {
  if (!lines_.at_line_end()) lines_.reject(InputFault::syntax, "the line goes on after the last vertex");
  for (long long f = 0; f < faces_; ++f) {
    require(lines_.next(), f, faces_, "faces");
    const std::size_t line = lines_.line();
    read_corners(f, read_count());
    check_colour(f, line);
  }
}

/// Three corners or more, of which none follows itself: what numbers that are no face seldom look like.
bool is_polygon(std::span<const Index> corners) {
  return corners.size() >= 3 && corners.front() != corners.back() &&
         std::ranges::adjacent_find(corners) == corners.end();
}

void OffReader::read_faces() {
  for (long long f = 0; f < faces_; ++f) {
    require(lines_.seek(), f, faces_, "faces");
    rows_.begin(lines_);
    read_corners(f, read_count());
    if (!is_polygon(reading_.soup.face(f)))
      lines_.reject(InputFault::syntax, "face " + std::to_string(f) + " is no polygon");
    rows_.end(lines_);
  }
}

}  // namespace

OffReading read_off_with(const SourceFile& file, const OffLayout& layout) { return OffReader(file, layout).read(); }

std::vector<std::size_t> off_columns(const SourceFile& file) {
  const std::string prefix = prefix_of(first_word(file));
  std::size_t columns = 3;
  if (prefix.find('N') != prefix.npos) columns += 3;
  if (prefix.find("ST") != prefix.npos) columns += 2;
  if (prefix.find('C') == prefix.npos) return {columns};
  return {columns + 4, columns + 3};
}

}  // namespace geodrome::input
