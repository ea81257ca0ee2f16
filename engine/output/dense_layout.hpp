// SPDX-License-Identifier: MIT
#pragma once

#include "engine/formats/matrix_format.hpp"

namespace geodrome {

/// Where everything stands in an unfinished matrix: the dense file as it will be (header, rows), then the footer of
/// partial_footer.hpp. Offsets in bytes.
class DenseLayout {
 public:
  /// `fingerprint_bytes`: the length of the text in the footer. Throws RefusedError if the matrix is more than a file
  /// can hold.
  DenseLayout(const DenseFormat& format, const MatrixShape& shape, std::uint64_t fingerprint_bytes);

  const std::string& header() const noexcept { return header_; }
  std::uint64_t row_bytes() const noexcept { return row_bytes_; }
  std::uint64_t row(std::uint64_t i) const noexcept { return header_.size() + i * row_bytes_; }
  /// The end of the rows, which is the size of the finished dense file.
  std::uint64_t footer() const noexcept { return row(rows_); }
  std::uint64_t checksum(std::uint64_t i) const noexcept { return footer() + i * sizeof(std::uint64_t); }
  std::uint64_t fingerprint() const noexcept { return checksum(rows_); }
  std::uint64_t trailer() const noexcept { return end() - trailer_bytes; }
  /// The size of the unfinished file.
  std::uint64_t end() const noexcept;

  static constexpr std::uint64_t trailer_bytes = 64;

 private:
  std::string header_;
  std::uint64_t rows_, row_bytes_, fingerprint_bytes_;
};

}  // namespace geodrome
