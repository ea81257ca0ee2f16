// SPDX-License-Identifier: MIT
#include "engine/formats/npy.hpp"

#include "engine/formats/table.hpp"

namespace geodrome {

namespace {

std::string header_of(const std::string& shape, ScalarType scalar) {
  constexpr std::size_t preamble = 10, alignment = 64;
  std::string dictionary = std::string("{'descr': '") + (scalar == ScalarType::float64 ? "<f8" : "<f4") +
                           "', 'fortran_order': False, 'shape': (" + shape + "), }";
  const std::size_t used = preamble + dictionary.size() + 1;
  dictionary.append((alignment - used % alignment) % alignment, ' ');
  dictionary += '\n';

  const std::size_t length = dictionary.size();
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(length & 0xff);
  header += static_cast<char>(length >> 8);
  return header + dictionary;
}

}  // namespace

std::string npy_header(std::uint64_t rows, std::uint64_t columns, ScalarType scalar) {
  return header_of(std::to_string(rows) + ", " + std::to_string(columns), scalar);
}

std::string npy_header(std::uint64_t count, ScalarType scalar) {
  return header_of(std::to_string(count) + ",", scalar);
}

Format npy_format() {
  static constexpr MatrixFormat matrix{.dense = npy_dense};
  return {.name = "NPY",
          .endings = {".npy"},
          .uses = {{Content::matrix, "float64 or float32 in C order, to compare with", "float64 or float32"},
                   {.content = Content::pairs, .written = "float64, a vector"}},
          .matrix = &matrix};
}

}  // namespace geodrome
