// SPDX-License-Identifier: MIT
// Matrices of .npy files that somebody else wrote. The first byte: 1 puts the magic word before the rest.
#include <bit>

#include "engine/formats/npy.hpp"
#include "engine/formats/npy_matrix.hpp"
#include "tests/fuzzing/memory_file.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {
namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";

struct Rows {
  std::uint64_t rows, columns;
  ScalarType scalar;
  std::vector<std::vector<double>> values;
};

Rows rows_of(const MemoryFile& file) {
  NpyMatrix matrix(file.path());
  Rows rows{matrix.rows(), matrix.columns(), matrix.scalar(), {}};
  if (matrix.columns() == 0) return rows;  // there may be any number of rows without an entry
  for (std::uint64_t row = 0; row < matrix.rows(); ++row) rows.values.push_back(matrix.read(row));
  return rows;
}

std::string file_of(const Rows& rows) {
  std::string bytes = npy_header(rows.rows, rows.columns, rows.scalar);
  const auto append = [&](auto number) {
    const auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
    bytes.append(raw.data(), raw.size());
  };
  for (const std::vector<double>& row : rows.values)
    for (const double value : row)
      rows.scalar == ScalarType::float64 ? append(value) : append(static_cast<float>(value));
  return bytes;
}

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || a != a; }

}  // namespace

void check_npy(std::string_view input) {
  static const MemoryFile file;
  const std::string bytes = std::string(Choices(input).bit(0) ? npy_magic : "") + std::string(rest_of(input));
  file.hold(bytes);
  const auto rows = read_or_refusal(file.path(), bytes, [&] { return rows_of(file); });
  if (!rows) return;
  for (const std::vector<double>& row : rows->values) demand(row.size() == rows->columns, "rows are whole");
  demand(rows->rows * rows->columns * bytes_of(rows->scalar) <= bytes.size(), "no more entries than bytes");
  file.hold(file_of(*rows));
  const Rows again = rows_of(file);
  demand(again.rows == rows->rows && again.columns == rows->columns && again.scalar == rows->scalar,
         "a matrix that is written has its shape");
  for (std::size_t i = 0; i < rows->values.size(); ++i)
    for (std::size_t j = 0; j < rows->columns; ++j)
      demand(same(rows->values[i][j], again.values[i][j]), "a matrix that is written reads back");
}

std::vector<std::string> npy_seeds() {
  const std::string whole(1, '\0'), without_magic(1, '\1');
  const auto version = [](char major, const std::string& dictionary, const std::string& bytes) {
    std::string text = {major, '\0', static_cast<char>(dictionary.size()), '\0'};
    if (major > 1) text += std::string(2, '\0');
    return text + dictionary + bytes;
  };
  const std::string six(48, '\x3f');
  return {whole + npy_header(2, 3, ScalarType::float64) + six,
          whole + npy_header(3, 4, ScalarType::float32) + six,
          without_magic + version(2, "{'shape':(2,3),'fortran_order':False,'descr':'<f8'}", six),
          without_magic + version(1, "{'descr': '>f8', 'fortran_order': True, 'shape': (6,), }\n", six),
          without_magic + version(3, "{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (1, 2, 3), }", six),
          without_magic + version(1, "{'descr': '<f4', 'fortran_order': False, 'shape': (0, 7), }", "")};
}

}  // namespace geodrome::fuzzing
