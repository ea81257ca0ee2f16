// SPDX-License-Identifier: MIT
#include "engine/formats/line_reader.hpp"
#include "engine/formats/soup.hpp"

// One point a line: three numbers; more (normals, colours) if every line has as many. '#' starts a comment.
namespace geodrome::input {

Soup parse_xyz(const SourceFile& file) {
  Soup soup{.format = "xyz"};
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

}  // namespace geodrome::input
