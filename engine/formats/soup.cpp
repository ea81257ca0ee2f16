// SPDX-License-Identifier: MIT
#include "engine/formats/soup.hpp"

#include <algorithm>
#include <string_view>

#include "engine/formats/line_reader.hpp"
#include "engine/formats/lower_extension.hpp"

namespace geodrome::input {
namespace {

using Parser = Soup (*)(const SourceFile&);

void reject_compressed(const SourceFile& file) {
  struct Packing {
    std::string_view magic, name, remedy;
  };
  constexpr Packing packings[] = {
      {"\x1F\x8B", "gzip", "gunzip"},         {"BZh", "bzip2", "bunzip2"},
      {"\xFD\x37zXZ", "xz", "unxz"},          {"PK\x03\x04", "zip", "unzip"},
      {"\x28\xB5\x2F\xFD", "zstd", "unzstd"},
  };
  for (const Packing& packing : packings)
    if (file.bytes.starts_with(packing.magic))
      reject(file, InputFault::syntax, "the file is " + std::string(packing.name) + "-compressed",
             "unpack it with " + std::string(packing.remedy));
}

// An OFF keyword with whatever may stand before and after it: COFF, STNOFF, 4OFF, OFF6 (a count without a blank).
bool is_off_keyword(std::string_view word) {
  const std::size_t off = word.find("OFF");
  return off != word.npos && word.substr(0, off).find_first_not_of("STCN4n") == word.npos;
}

Parser parser_by_content(const SourceFile& file) {
  if (has_size_of_binary_stl(file)) return parse_stl;
  LineReader lines(file, {.comment = '#'});
  if (!lines.next()) return nullptr;
  const std::string_view word = lines.word();
  if (word == "ply") return parse_ply;
  if (is_off_keyword(word)) return parse_off;
  if (word == "solid") return parse_stl;
  return nullptr;
}

Parser parser_by_name(const SourceFile& file) {
  const std::string extension = lower_extension(file.path);
  if (extension == ".off") return parse_off;
  if (extension == ".obj") return parse_obj;
  if (extension == ".ply") return parse_ply;
  if (extension == ".stl") return parse_stl;
  for (const char* cloud : {".xyz", ".pts", ".asc", ".txt"})
    if (extension == cloud) return parse_xyz;
  return nullptr;
}

}  // namespace

Soup parse(const SourceFile& file, std::string_view weight_property) {
  reject_compressed(file);
  const Parser by_content = parser_by_content(file), by_name = parser_by_name(file);
  if (!by_content && !by_name)
    reject(file, InputFault::unsupported, "neither content nor name tells the format",
           "use OFF, OBJ, PLY, STL or XYZ, and the ending of the format in the file's name");
  const Parser parser = by_content ? by_content : by_name;
  if (!weight_property.empty() && parser != parse_ply)
    reject(file, InputFault::unsupported, "only faces of PLY have properties such as " + quoted(weight_property),
           "give the weights as a text file with one number a line for each face");
  Soup soup = weight_property.empty() ? parser(file) : parse_weighted_ply(file, weight_property);
  if (by_content && by_name && by_content != by_name)
    soup.findings.push_back({Finding::Severity::note,
                             "format_by_content",
                             "The content is " + soup.format + ", whatever the file's name says.",
                             1,
                             {}});
  return soup;
}

void check_announced(const SourceFile& file, const std::string& element, std::uint64_t count,
                     std::size_t least_bytes_each, std::size_t bytes_left) {
  const std::string announced = "the header announces " + std::to_string(count) + " " + element;
  // The last line of a text may lack its end.
  if (count > (bytes_left + 1) / least_bytes_each)
    reject(file, InputFault::truncated,
           announced + ", which do not fit into the " + std::to_string(bytes_left) + " bytes that follow");
  if (count >= no_index) reject(file, InputFault::unsupported, announced + ", more than 32 bits count");
}

Index checked_corner(const SourceFile& file, std::size_t face, long long index, std::size_t vertex_count,
                     long long base) {
  if (index >= 0 && static_cast<unsigned long long>(index) < vertex_count) return static_cast<Index>(index);
  reject(file, InputFault::index,
         "face " + std::to_string(face) + " names vertex " + std::to_string(index + base) + ", but there are " +
             std::to_string(vertex_count) + " vertices, counted from " + std::to_string(base));
}

void note_trailing_data(Soup& soup) {
  soup.findings.push_back({Finding::Severity::warning,
                           "trailing_data",
                           "The file goes on after all that it announces; the rest was not read.",
                           1,
                           {}});
}

}  // namespace geodrome::input
