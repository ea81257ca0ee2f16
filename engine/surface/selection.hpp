// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/named_points.hpp"

/// The lists of points and pairs that users write, in two steps: `parse_...` knows the syntax and needs no surface, so
/// that mistakes are told before one is made; `resolve` (search/named_points.hpp) finds the places.
namespace geodrome {

/// Numbers beyond it are refused, as those of an input are: their squares must stay in the range of double.
constexpr double largest_number = 1e100;

/// An entry of a list, as it is written. One of kind `row` names `count` rows: index, index + step, ...
struct PointEntry {
  enum class Kind : std::uint8_t { row, position, on_face };

  Kind kind = Kind::row;
  std::uint32_t line = 0;             ///< of its file, from 1
  std::size_t index = 0;              ///< the first row, or the face as counted in the input
  std::uint64_t count = 1, step = 1;  ///< below 2^32: a range takes no room before it is known that its rows exist
  std::array<double, 3> numbers{};    ///< x, y, z, or barycentric coordinates, which sum to 1
  double start = 0;
  std::string label;  ///< of an entry that is no row
};

/// A list of points. `file`: where it stands, for messages; empty: in the text itself.
struct Selection {
  std::string file;
  bool all = false;
  std::vector<PointEntry> entries;

  bool has_starts() const;
  std::uint64_t count() const;  ///< of the points that the entries name
};

struct PairEntry {
  PointEntry from, to;
};

struct PairSelection {
  std::string file;
  std::vector<PairEntry> pairs;
  std::string hash;  ///< of the file's bytes
};

/// Reads the text that `select` reads. Throws OptionError for a bad list, InputError naming file and line for a bad
/// file.
Selection parse_selection(const std::string& text);

/// As `parse_selection`, for a text that should name one point: commas may also stand between the numbers of 'x,y,z'
/// and 'face,b0,b1,b2', which are then no list of rows.
Selection parse_place(const std::string& text);

/// Reads the file that `select_pairs` reads. Throws InputError naming file and line.
PairSelection parse_pairs(const std::filesystem::path& file);

/// A point of the surface's mesh under the name `label`. Throws OptionError, naming it, for a face that is not there
/// and for barycentric coordinates that are negative or do not sum to 1.
NamedPoint point_on(const SurfaceMesh& mesh, const SurfacePoint& at, const std::string& label);

}  // namespace geodrome
