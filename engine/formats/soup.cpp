// SPDX-License-Identifier: MIT
#include "engine/formats/soup.hpp"

namespace geodrome::input {

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
