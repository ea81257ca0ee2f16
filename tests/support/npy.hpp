// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <stdexcept>

#include "tests/support/program.hpp"

namespace geodrome::testing {

/// A little-endian float64 .npy matrix in C order, read by the format's own rules; a vector is one of one row.
struct Matrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;

  double operator()(std::size_t i, std::size_t j) const { return values[i * columns + j]; }
};

inline Matrix read_npy(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  if (bytes.substr(0, 6) != "\x93NUMPY" || bytes[6] != 1) throw std::runtime_error("no .npy version 1 file");
  const std::size_t length = static_cast<unsigned char>(bytes[8]) + 256 * static_cast<unsigned char>(bytes[9]);
  const std::string header = bytes.substr(10, length);
  if (header.find("'<f8'") == std::string::npos || header.find("'fortran_order': False") == std::string::npos)
    throw std::runtime_error("not little-endian float64 in C order: " + header);
  Matrix matrix;
  const std::string shape = header.substr(header.find('(') + 1);
  const std::string second = shape.substr(shape.find(',') + 1);
  const bool is_vector = second.starts_with(')');
  matrix.rows = is_vector ? 1 : std::stoul(shape);
  matrix.columns = std::stoul(is_vector ? shape : second);
  matrix.values.resize(matrix.rows * matrix.columns);
  if (bytes.size() != 10 + length + 8 * matrix.values.size()) throw std::runtime_error("size and shape differ");
  std::memcpy(matrix.values.data(), bytes.data() + 10 + length, 8 * matrix.values.size());
  return matrix;
}

}  // namespace geodrome::testing
