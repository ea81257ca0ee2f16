// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "engine/formats/soup.hpp"

namespace geodrome::input {

/// Reads points, one a line, in columns separated by blanks, commas, semicolons or tabs. '#' starts a comment. Before
/// the points may stand their number, which must hold, and the names of their columns, in a comment ("//X Y Z I",
/// "# x y z") or without ("x,y,z"). `columns`: those of x, y and z, as in `parse_columns`; empty: those of these names,
/// else the first three. What is in other columns must be numbers where nothing names the columns. Rejects, naming the
/// line, numbers with decimal commas, and four and more columns of which the first, not chosen, counts the lines.
Soup read_point_table(const SourceFile& file, std::string_view columns);

}  // namespace geodrome::input
