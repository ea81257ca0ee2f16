// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/formats/soup.hpp"

namespace geodrome::input {

/// A way in which the numbers of an OFF file may lie on its lines.
struct OffLayout {
  std::size_t columns = 0;       ///< of a vertex in a stream of numbers; 0: one vertex a line, as long as the first
  bool faces_on_lines = true;    ///< a face begins its line, and what follows its corners there is its colour
  bool edges_on_a_line = false;  ///< the number of edges stands on a line after that of the faces
};

/// An OFF file read with one layout.
struct OffReading {
  Soup soup;
  bool complete = false;  ///< every number was used
  bool coloured = false;  ///< some were taken as colours of faces
  std::size_t torn = 0;   ///< the line where a row begins that shares lines with others; 0: none does
  std::size_t mixed = 0;  ///< the line where colours of faces begin to differ in length as they seldom do; 0: none
};

/// Reads OFF with one layout. Rejects, naming line and element, what does not fit it.
OffReading read_off_with(const SourceFile& file, const OffLayout& layout);

/// The numbers that a vertex may have by the keyword: normal, colour with or without alpha, texture.
std::vector<std::size_t> off_columns(const SourceFile& file);

}  // namespace geodrome::input
