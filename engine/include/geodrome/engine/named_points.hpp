// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A source or target that the user named.
struct NamedPoint {
  Place place;
  double start = 0;      ///< start distance; 0 for targets
  Index row = no_index;  ///< the row of the input, if it was named by its row
  std::string label;     ///< the row, "@k" for point k of a file that names it otherwise, else the entry as written
  /// The distance from the surface of a point that was named by its coordinates; 0 where it is no more than rounding
  /// (1e-6 of the surface's diagonal), and for points named otherwise.
  double off_surface = 0;
};

/// The two ends of a pair that the user named. The label of an end that is no row is the entry as it was written.
struct NamedPair {
  NamedPoint from, to;
};

struct PairList {
  std::vector<NamedPair> pairs;
  std::string hash;  ///< of the file's bytes: 32 hexadecimal digits (XXH3, 128 bits)
};

/// Reads "all", "@FILE", or entries separated by commas: "0,5,9", "0-5, 100:200:10, 0.1 0.2 0.3". An entry, or a line
/// of a file, is a row `i`, rows `a-b` (with b) or `a:b:step` (without b), a point `x y z` (its closest surface point
/// is meant, on the smooth surface if there is one; for a cloud the point itself takes part in D = max(surface
/// distance, |st|)), or `face b0 b1 b2` (face as counted in the input, barycentric coordinates >= 0 that sum to 1, both
/// up to 1e-9), each with an optional `+ start`; blank lines and `#` comments are passed over. Rows and faces count
/// from 0, and 3.0e+00 is row 3 too. A row named twice is there twice. Throws OptionError for a bad list, InputError
/// naming file and line for a bad file.
std::vector<NamedPoint> select(const std::string& text, const Input& input, const PlacedSurface& surface);

/// Reads a file with a pair a line: two entries as in the files of `select`, without a start distance, separated by a
/// comma: "3, 17", "12 0.2 0.3 0.5, 40 0.1 0.1 0.8", "3, 0.5 1 0.2"; two rows need none: "3 17". Blank lines and `#`
/// comments are passed over. Throws InputError naming file and line. O(file), and a search of the closest point for
/// each `x y z`.
PairList select_pairs(const std::filesystem::path& file, const Input& input, const PlacedSurface& surface);

}  // namespace geodrome
