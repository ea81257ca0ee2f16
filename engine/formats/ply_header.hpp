// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/formats/line_reader.hpp"

namespace geodrome::input {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}
constexpr bool is_integer(PlyType type) { return type < PlyType::float32; }

/// The use that the engine makes of a property's values.
enum class PlyRole : std::uint8_t { x, y, z, corners, strip, weight, unused };
constexpr std::size_t ply_role_count = 7;

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< of a list
  PlyRole role = PlyRole::unused;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The fewest bytes that one row takes.
  std::size_t least_bytes(PlyEncoding encoding) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::uint64_t vertex_count = 0;
  std::size_t body_offset = 0, lines = 0;
};

/// Reads the header and checks it: there is one vertex element with x, y and z; faces and strips are lists of integers;
/// what is announced fits into the file. The faces' number named `weight_property`, if that is not empty, gets the role
/// of the weight; rejects (unsupported) faces that have none, and strips.
PlyHeader read_ply_header(const SourceFile& file, std::string_view weight_property = {});

}  // namespace geodrome::input
