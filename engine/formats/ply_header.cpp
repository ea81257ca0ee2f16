// SPDX-License-Identifier: MIT
#include "engine/formats/ply_header.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "engine/formats/soup.hpp"

namespace geodrome::input {
namespace {

PlyType type_named(const LineReader& lines, std::string_view word) {
  constexpr std::pair<std::string_view, PlyType> names[] = {
      {"char", PlyType::int8},      {"uchar", PlyType::uint8},    {"short", PlyType::int16},
      {"ushort", PlyType::uint16},  {"int", PlyType::int32},      {"uint", PlyType::uint32},
      {"float", PlyType::float32},  {"double", PlyType::float64}, {"int8", PlyType::int8},
      {"uint8", PlyType::uint8},    {"int16", PlyType::int16},    {"uint16", PlyType::uint16},
      {"int32", PlyType::int32},    {"uint32", PlyType::uint32},  {"float32", PlyType::float32},
      {"float64", PlyType::float64}};
  for (const auto& [name, type] : names)
    if (name == word) return type;
  lines.reject(InputFault::syntax, quoted(word) + " is no type of PLY");
}

PlyEncoding encoding_named(const LineReader& lines, std::string_view word) {
  if (word == "ascii") return PlyEncoding::ascii;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  lines.reject(InputFault::syntax, quoted(word) + " is no encoding of PLY");
}

PlyElement read_element(LineReader& lines) {
  PlyElement element{std::string(lines.word())};
  const long long count = lines.integer();
  if (count < 0) lines.reject(InputFault::syntax, "the count is negative");
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

PlyRole role_of(std::string_view element, const PlyProperty& property) {
  const std::string_view name = property.name;
  if (element == "vertex" && !property.count_type) {
    if (name == "x") return PlyRole::x;
    if (name == "y") return PlyRole::y;
    if (name == "z") return PlyRole::z;
  }
  if (!property.count_type || (name != "vertex_indices" && name != "vertex_index")) return PlyRole::unused;
  if (element == "face") return PlyRole::corners;
  return element == "tristrips" ? PlyRole::strip : PlyRole::unused;
}

PlyProperty read_property(LineReader& lines, std::string_view element) {
  PlyProperty property;
  std::string_view word = lines.word();
  if (word == "list") {
    property.count_type = type_named(lines, lines.word());
    if (!is_integer(*property.count_type)) lines.reject(InputFault::syntax, "the length of a list is no integer");
    word = lines.word();
  }
  property.type = type_named(lines, word);
  property.name = lines.word();
  if (property.name.empty()) lines.reject(InputFault::syntax, "a property has no name");
  property.role = role_of(element, property);
  if ((property.role == PlyRole::corners || property.role == PlyRole::strip) && !is_integer(property.type))
    lines.reject(InputFault::syntax, "the corners of faces are no integers");
  return property;
}

std::size_t count_role(const PlyElement& element, PlyRole role) {
  return std::count_if(element.properties.begin(), element.properties.end(),
                       [role](const PlyProperty& p) { return p.role == role; });
}

std::size_t count_elements(const PlyHeader& header, std::string_view name) {
  return std::count_if(header.elements.begin(), header.elements.end(),
                       [name](const PlyElement& element) { return element.name == name; });
}

void check(const SourceFile& file, PlyHeader& header) {
  if (count_elements(header, "vertex") != 1 || count_elements(header, "face") > 1 ||
      count_elements(header, "tristrips") > 1)
    reject(file, InputFault::syntax, "the header needs one element 'vertex' and at most one 'face' and 'tristrips'");
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      header.vertex_count = element.count;
      for (const PlyRole role : {PlyRole::x, PlyRole::y, PlyRole::z})
        if (count_role(element, role) != 1)
          reject(file, InputFault::syntax, "vertices need one x, one y and one z each");
    }
    if (element.name == "face" && element.count > 0 && count_role(element, PlyRole::corners) != 1)
      reject(file, InputFault::syntax, "faces need one list named vertex_indices");
    if (element.name == "tristrips" && element.count > 0 && count_role(element, PlyRole::strip) != 1)
      reject(file, InputFault::syntax, "triangle strips need one list named vertex_indices");
    if (!element.properties.empty())
      check_announced(file, "rows of '" + element.name + "'", element.count, element.least_bytes(header.encoding),
                      file.bytes.size() - header.body_offset);
  }
}

std::string scalars_of(const PlyElement& element) {
  std::string names;
  for (const PlyProperty& property : element.properties)
    if (!property.count_type) names += (names.empty() ? "'" : ", '") + property.name + "'";
  return names.empty() ? "they have no numbers" : "their numbers are " + names;
}

void find_weight(const SourceFile& file, std::string_view name, PlyElement& faces) {
  if (faces.name == "tristrips")
    reject(file, InputFault::unsupported, "triangle strips have no weights", "convert the file to faces");
  for (PlyProperty& property : faces.properties)
    if (property.name == name && !property.count_type) property.role = PlyRole::weight;
  const std::size_t found = count_role(faces, PlyRole::weight);
  if (found == 1) return;
  const std::string many = found == 0 ? "have no number named " : "have several numbers named ";
  reject(file, InputFault::unsupported, "the faces " + many + quoted(name),
         scalars_of(faces) + "; a text file with a number per face does as well");
}

}  // namespace

std::size_t PlyElement::least_bytes(PlyEncoding encoding) const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += encoding == PlyEncoding::ascii ? 2 : size_of(property.count_type.value_or(property.type));
  return bytes;
}

PlyHeader read_ply_header(const SourceFile& file, std::string_view weight_property) {
  LineReader lines(file);
  if (!lines.next() || lines.word() != "ply")
    reject(file, InputFault::syntax, "the magic word 'ply' is missing", "check that the file is PLY");
  PlyHeader header;
  bool has_format = false;
  while (lines.next()) {
    const std::string_view word = lines.word();
    if (word == "end_header") {
      if (!has_format) lines.reject(InputFault::syntax, "the header names no format");
      header.body_offset = lines.offset();
      header.lines = lines.line();
      check(file, header);
      for (PlyElement& element : header.elements)
        if (!weight_property.empty() && (element.name == "face" || element.name == "tristrips") && element.count > 0)
          find_weight(file, weight_property, element);
      return header;
    }
    if (word == "format") {
      header.encoding = encoding_named(lines, lines.word());
      has_format = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(lines));
    } else if (word == "property") {
      if (header.elements.empty()) lines.reject(InputFault::syntax, "a property stands before the first element");
      PlyElement& element = header.elements.back();
      element.properties.push_back(read_property(lines, element.name));
    } else if (word != "comment" && word != "obj_info") {
      lines.reject(InputFault::syntax, quoted(word) + " is no word of a PLY header");
    }
  }
  reject(file, InputFault::truncated, "the file ends inside its header");
}

}  // namespace geodrome::input
