// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/formats/source_file.hpp"
#include "geodrome/finding.hpp"
#include "geodrome/geometry.hpp"

namespace geodrome::input {

/// The content of a file as it is stored: points and polygons of any number of corners. Every corner is a position.
struct Soup {
  std::string format;                 ///< the name in the table of formats, in lower case; set by `parse`
  std::vector<Vec3> positions;        ///< may be non-finite
  std::vector<Index> corners;         ///< of all faces, one after the other
  std::vector<std::size_t> face_end;  ///< per face: one past its last corner
  std::vector<double> face_weights;   ///< per face, unchecked; empty if no property was asked for
  bool vertices_by_place = false;     ///< equal positions are one vertex, which the format cannot say (STL)
  std::vector<Finding> findings;

  std::size_t face_count() const noexcept { return face_end.size(); }
  std::span<const Index> face(std::size_t f) const {
    const std::size_t begin = f == 0 ? 0 : face_end[f - 1];
    return std::span(corners).subspan(begin, face_end[f] - begin);
  }
};

/// What is read of a file that holds more than a mesh or points.
struct ParseChoice {
  std::string_view weight_property;  ///< of the faces, for `Soup::face_weights`; empty: none
  std::string_view columns;          ///< of a table of points, as in `parse_columns`; empty: not chosen
};

/// Reads a file of the format that its content, or else its name, tells (table.hpp). Throws InputError, also for a
/// choice that the file does not offer, OptionError for columns that are not there.
Soup parse(const SourceFile& file, const ParseChoice& choice = {});

/// Rejects (truncated) a header's count of elements that the rest of the file cannot hold, and (unsupported) one that
/// Index cannot count: to be called before anything is reserved.
void check_announced(const SourceFile& file, const std::string& element, std::uint64_t count,
                     std::size_t least_bytes_each, std::size_t bytes_left);

/// `index` if it is one of `vertex_count`; rejects it otherwise. `base`: what the format counts from.
Index checked_corner(const SourceFile& file, std::size_t face, long long index, std::size_t vertex_count,
                     long long base = 0);

/// Records that the file goes on after all that was announced.
void note_trailing_data(Soup& soup);

}  // namespace geodrome::input
