// SPDX-License-Identifier: MIT
#include "engine/formats/line_reader.hpp"
#include "engine/formats/table.hpp"
#include "engine/formats/text_output.hpp"

// One point a line: three numbers; more (normals, colours) if every line has as many. '#' starts a comment.
namespace geodrome {
namespace {

using namespace input;

Soup read_xyz(const SourceFile& file) {
  Soup soup;
  LineReader lines(file, {.comment = '#'});
  std::size_t columns = 0;
  while (lines.next()) {
    LineReader counting = lines;
    std::size_t found = 0;
    while (!counting.word().empty()) ++found;
    if (columns == 0) columns = found;
    if (found < 3 || found != columns)
      lines.reject(InputFault::syntax,
                   "the line has " + std::to_string(found) + " columns, " +
                       (columns < 3 ? "a point needs three" : "the first has " + std::to_string(columns)));
    soup.positions.push_back(lines.point());
    lines.further_numbers();
    if (soup.positions.size() >= no_index) lines.reject(InputFault::unsupported, "more points than 32 bits count");
  }
  return soup;
}

std::string xyz_text(const MeshToWrite& points) {
  std::string text;
  for (const Vec3& p : points.positions) append_point(text, "", p);
  return text;
}

}  // namespace

Format xyz_format() {
  return {.name = "XYZ",
          .endings = {".xyz", ".pts", ".asc", ".txt"},
          .uses = {{Content::points, "", ""}},
          .read = read_xyz,
          .write = xyz_text};
}

}  // namespace geodrome
