// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace geodrome {

/// The content of files that are read or written.
enum class Content {
  mesh,
  points,
  weights,     ///< of the faces of a mesh
  matrix,      ///< of distances
  nearest,     ///< the nearest source of each target
  pairs,       ///< read: pairs of points; written: their distances
  path,        ///< one shortest path
  report,      ///< of a run
  figures,     ///< of a comparison
  page,        ///< of a comparison
  pair_index,  ///< of a pair oracle
};

/// The formats that are read, for a help text: "PLY (.ply: ascii, both endians), OFF (.off), ...". Empty if none is.
std::string help_for_reading(Content content);

/// The endings that a file to be written may have, for a help text: ".ply (binary, double), .off, ...". Compared
/// without regard to case. Empty if the name tells nothing.
std::string help_for_writing(Content content);

/// The formats of an input, for a help text: "PLY, OFF (meshes or points) or XYZ (points)".
std::string help_for_input();

/// All formats as a table in Markdown, a row for each kind of content: what is read, what is written.
std::string table_of_formats();

}  // namespace geodrome
