// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/formats/input_file.hpp"
#include "geodrome/engine/matrix_file.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {

/// A matrix of a .npy file that was made anywhere: two dimensions, float64 or float32, little-endian, C order; format
/// versions 1 to 3. Source: numpy.lib.format, "NPY format".
class NpyMatrix {
 public:
  /// Reads the header. Throws InputError naming the file: io, (syntax) for what is no .npy, (unsupported) for another
  /// type, order or number of dimensions, (truncated) if the file has not the bytes that its shape takes.
  explicit NpyMatrix(const std::filesystem::path& file);

  std::uint64_t rows() const noexcept { return rows_; }
  std::uint64_t columns() const noexcept { return columns_; }
  ScalarType scalar() const noexcept { return scalar_; }
  std::string shape_text() const;  ///< "(3, 5)"

  /// Precondition: row < rows(). Throws InputError (io), also if the file was changed since it was opened.
  std::vector<double> read(std::uint64_t row) const;

 private:
  void parse(const std::string& header);
  [[noreturn]] void reject(InputFault fault, const std::string& what, const std::string& remedy = {}) const;

  std::filesystem::path file_;
  input::InputFile source_;
  std::uint64_t rows_ = 0, columns_ = 0, first_byte_ = 0;
  ScalarType scalar_ = ScalarType::float64;
};

}  // namespace geodrome
