// SPDX-License-Identifier: MIT
#include <string_view>

#include "engine/formats/line_reader.hpp"
#include "engine/formats/table.hpp"
#include "engine/formats/text_output.hpp"

// Object File Format as Geomview, CGAL and MeshLab write it: a keyword, three counts, then one vertex or face a line.
namespace geodrome {
namespace {

using namespace input;

struct Counts {
  long long vertices = 0, faces = 0;
};

long long count_of(LineReader& lines, long long count) {
  if (count < 0) lines.reject(InputFault::syntax, "a count is negative");
  return count;
}

void check_keyword(const LineReader& lines, std::string_view keyword) {
  const std::size_t off = keyword.find("OFF");
  if (off == keyword.npos) lines.reject(InputFault::syntax, "the keyword OFF is missing, found " + quoted(keyword));
  if (keyword.substr(0, off).find_first_of("4n") != keyword.npos)
    lines.reject(InputFault::unsupported, "vertices are not in three dimensions");
}

// The counts may stand on the keyword's line, even without a blank between ("OFF490 518 0").
Counts read_header(const SourceFile& file, LineReader& lines) {
  if (!lines.next()) reject(file, InputFault::empty, "the file holds nothing but blanks and comments");
  const std::string_view keyword = lines.word();
  check_keyword(lines, keyword);
  const std::string_view glued = keyword.substr(keyword.find("OFF") + 3);
  LineReader first = lines;
  const std::string_view second = first.word();
  if (second == "BINARY") lines.reject(InputFault::unsupported, "binary OFF is not read", "convert it to PLY");
  Counts counts;
  if (!glued.empty()) {
    for (const char digit : glued) {
      if (digit < '0' || digit > '9' || counts.vertices > 99'999'999'999)
        lines.reject(InputFault::syntax, quoted(keyword) + " is no keyword");
      counts.vertices = 10 * counts.vertices + (digit - '0');
    }
  } else {
    if (second.empty() && !lines.next()) reject(file, InputFault::truncated, "the file ends after its keyword");
    counts.vertices = count_of(lines, lines.integer());
  }
  counts.faces = count_of(lines, lines.integer());
  lines.further_numbers();  // the number of edges, which nobody needs
  return counts;
}

void read_vertices(const SourceFile& file, LineReader& lines, long long count, Soup& soup) {
  soup.positions.reserve(count);
  std::size_t further = 0;  // normals, colours, texture
  for (long long v = 0; v < count; ++v) {
    if (!lines.next())
      reject(file, InputFault::truncated,
             "the file ends after " + std::to_string(v) + " of " + std::to_string(count) + " vertices");
    soup.positions.push_back(lines.point());
    const std::size_t found = lines.further_numbers();
    if (v == 0) further = found;
    if (found != further)
      lines.reject(InputFault::syntax, "the line has " + std::to_string(3 + found) + " numbers, the first vertex has " +
                                           std::to_string(3 + further));
  }
}

void read_faces(const SourceFile& file, LineReader& lines, long long count, Soup& soup) {
  soup.face_end.reserve(count);
  soup.corners.reserve(3 * count);
  for (long long f = 0; f < count; ++f) {
    if (!lines.next())
      reject(file, InputFault::truncated,
             "the file ends after " + std::to_string(f) + " of " + std::to_string(count) + " faces");
    const long long corners = count_of(lines, lines.integer());
    for (long long i = 0; i < corners; ++i)
      soup.corners.push_back(checked_corner(file, f, lines.integer(), soup.positions.size()));
    soup.face_end.push_back(soup.corners.size());
    lines.further_numbers();  // a colour
  }
}

Soup read_off(const SourceFile& file) {
  LineReader lines(file, {.comment = '#'});
  const Counts counts = read_header(file, lines);
  constexpr std::size_t vertex_bytes = 6, face_bytes = 2;  // "0 0 0\n" and "0\n"
  const std::size_t left = file.bytes.size() - lines.offset();
  check_announced(file, "vertices", counts.vertices, vertex_bytes, left);
  check_announced(file, "faces", counts.faces, face_bytes, left);
  Soup soup;
  read_vertices(file, lines, counts.vertices, soup);
  read_faces(file, lines, counts.faces, soup);
  if (lines.next()) note_trailing_data(soup);
  return soup;
}

/// An OFF keyword with whatever may stand before and after it: COFF, STNOFF, 4OFF, OFF6 (a count without a blank).
Evidence off_evidence(const SourceFile& file) {
  const std::string_view word = first_word(file);
  const std::size_t off = word.find("OFF");
  const bool is_keyword = off != word.npos && word.substr(0, off).find_first_not_of("STCN4n") == word.npos;
  return is_keyword ? Evidence::keyword : Evidence::none;
}

std::string off_text(const MeshToWrite& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.positions.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& p : mesh.positions) append_point(text, "", p);
  for (const Triangle& t : mesh.triangles) append_face(text, "3", t, 0);
  return text;
}

}  // namespace

Format off_format() {
  return {.name = "OFF",
          .endings = {".off"},
          .uses = {{Content::mesh, "", ""}, {Content::points, "without faces", ""}},
          .evidence = off_evidence,
          .read = read_off,
          .write = off_text};
}

}  // namespace geodrome
