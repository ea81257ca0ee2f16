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

/// What a file holds, as it is stored: points and polygons of any number of corners. Every corner is a position.
struct Soup {
  std::string format;
  std::vector<Vec3> positions;        ///< may be non-finite
  std::vector<Index> corners;         ///< of all faces, one after the other
  std::vector<std::size_t> face_end;  ///< per face: one past its last corner
  std::vector<double> face_weights;   ///< per face, unchecked; empty if no property was asked for
  std::vector<Finding> findings;

  std::size_t face_count() const noexcept { return face_end.size(); }
  std::span<const Index> face(std::size_t f) const {
    const std::size_t begin = f == 0 ? 0 : face_end[f - 1];
    return std::span(corners).subspan(begin, face_end[f] - begin);
  }
};

/// Reads a file of the format that its content, or else its name, tells. `weight_property`: a property of the faces of
/// a PLY file, for `Soup::face_weights`; empty: none. Throws InputError, also if the faces have no such property.
Soup parse(const SourceFile& file, std::string_view weight_property = {});

// One parser per format. Each throws InputError, naming the line or element, for what is not of the format.
Soup parse_off(const SourceFile& file);
Soup parse_obj(const SourceFile& file);
Soup parse_ply(const SourceFile& file);
Soup parse_stl(const SourceFile& file);
Soup parse_xyz(const SourceFile& file);

/// A PLY file and the numbers of one property of its faces, which must be there if it has faces.
Soup parse_weighted_ply(const SourceFile& file, std::string_view weight_property);

/// The size is that of a binary STL with the announced number of facets.
bool has_size_of_binary_stl(const SourceFile& file);

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
