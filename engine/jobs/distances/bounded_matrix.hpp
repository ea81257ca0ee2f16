// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "geodrome/engine/matrix_file.hpp"

namespace geodrome {

/// A matrix, and beside it that of the lower bounds of its entries if they are wanted, as one sink: each row is
/// followed by that of its bounds. A row is there if it is in both files.
class BoundedMatrix final : public RowSink {
 public:
  /// Opens `spec`, and with it `bounds`, of the same shape, unless its name is empty. Throws as `MatrixFile::open`.
  BoundedMatrix(const MatrixFile::Spec& spec, const MatrixFile::Spec& bounds, bool resume);

  const MatrixFile& matrix() const { return matrix_; }
  /// None if they are not wanted.
  const std::optional<MatrixFile>& bounds() const { return bounds_; }

  bool has(std::uint64_t row) const override { return matrix_.has(row) && (!bounds_ || bounds_->has(row)); }
  /// Bounds are rounded down where floats are stored. Throws as `MatrixFile::write`.
  void write(std::uint64_t row, std::span<const double> values) override;
  void finish() override;

 private:
  MatrixFile matrix_;
  std::optional<MatrixFile> bounds_;
  std::size_t columns_;
  ScalarType scalar_;
};

}  // namespace geodrome
