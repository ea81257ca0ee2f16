// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "engine/formats/npy.hpp"
#include "geodrome/engine/matrix_file.hpp"
#include "geodrome/errors.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

inline constexpr double inf = std::numeric_limits<double>::infinity();

inline std::string bytes_in(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Changes the byte at `offset`.
inline void replace_byte(const fs::path& file, std::uint64_t offset) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekg(static_cast<std::streamoff>(offset));
  const char old = static_cast<char>(stream.get());
  stream.seekp(static_cast<std::streamoff>(offset));
  stream.put(static_cast<char>(old ^ 0x55));
}

inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

class MatrixFileTest : public ::testing::Test {
 protected:
  MatrixFile::Spec spec(const char* name, std::uint64_t rows = 5, std::uint64_t columns = 7) const {
    MatrixFile::Spec result;
    result.out = folder_ / name;
    result.rows = rows, result.columns = columns;
    result.fingerprint = R"({"input": "abc", "seed": 1, "solver": {"name": "exact", "delta": 0.5}})";
    return result;
  }

  static std::vector<double> row_values(std::uint64_t row, std::uint64_t columns) {
    std::mt19937_64 random(row);
    std::vector<double> values(columns);
    for (double& value : values) value = static_cast<double>(random() >> 11) * 0x1p-53;
    if (columns > 1) values[row % columns] = inf;
    return values;
  }

  static void write_missing(MatrixFile& matrix, const MatrixFile::Spec& spec) {
    for (std::uint64_t row = 0; row < spec.rows; ++row)
      if (!matrix.has(row)) matrix.write(row, row_values(row, spec.columns));
  }

  static std::string expected_npy(const MatrixFile::Spec& spec) {
    std::string bytes = npy_header(spec.rows, spec.columns, spec.scalar);
    for (std::uint64_t row = 0; row < spec.rows; ++row)
      for (const double value : row_values(row, spec.columns)) {
        const auto narrow = static_cast<float>(value);
        if (spec.scalar == ScalarType::float64)
          bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
        else
          bytes.append(reinterpret_cast<const char*>(&narrow), sizeof(narrow));
      }
    return bytes;
  }

  /// Leaves a partial with the first `rows` rows.
  void begin(const MatrixFile::Spec& spec, std::uint64_t rows) {
    MatrixFile matrix = MatrixFile::open(spec, false);
    for (std::uint64_t row = 0; row < rows; ++row) matrix.write(row, row_values(row, spec.columns));
  }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), {}));
  }

  static fs::path partial_of(const MatrixFile::Spec& spec) { return spec.out.string() + ".partial"; }

  TemporaryFolder folder_;
};

}  // namespace geodrome
