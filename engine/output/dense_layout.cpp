// SPDX-License-Identifier: MIT
#include "engine/output/dense_layout.hpp"

#include "geodrome/errors.hpp"

namespace geodrome {

DenseLayout::DenseLayout(const DenseFormat& format, const MatrixShape& shape, std::uint64_t fingerprint_bytes)
    : header_(format.header(shape)),
      rows_(shape.rows),
      row_bytes_(shape.columns * bytes_of(shape.scalar)),
      fingerprint_bytes_(fingerprint_bytes) {
  // Half of what an offset can express leaves room for the footer.
  constexpr std::uint64_t most = std::uint64_t{1} << 62;
  std::uint64_t size = 0;
  if (shape.rows > most / 64 || __builtin_mul_overflow(shape.rows, shape.columns, &size) ||
      __builtin_mul_overflow(size, bytes_of(shape.scalar), &size) || size > most)
    throw RefusedError(std::to_string(shape.rows) + " rows of " + std::to_string(shape.columns) +
                           " distances are more than a file can hold",
                       "ask for fewer sources or targets");
}

std::uint64_t DenseLayout::end() const noexcept {
  const std::uint64_t content = fingerprint() + fingerprint_bytes_;
  return (content + trailer_bytes - 1) / trailer_bytes * trailer_bytes + trailer_bytes;
}

}  // namespace geodrome
