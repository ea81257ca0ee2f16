// SPDX-License-Identifier: MIT
#include "geodrome/engine/row_sink.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/output/float32_row.hpp"

namespace geodrome {

namespace {

void require_row(std::uint64_t row, std::size_t rows, std::size_t values, std::uint64_t columns) {
  if (row >= rows || values != columns)
    throw std::logic_error("RowSink::write: row " + std::to_string(row) + " with " + std::to_string(values) +
                           " values does not belong into a matrix of " + std::to_string(rows) + " x " +
                           std::to_string(columns));
}

void require_all(std::span<const unsigned char> there) {
  const auto missing = std::ranges::count(there, 0);
  if (missing > 0)
    throw std::logic_error("RowSink::finish: " + std::to_string(missing) + " of " + std::to_string(there.size()) +
                           " rows are missing");
}

}  // namespace

template <class Number>
MatrixInMemory<Number>::MatrixInMemory(std::span<Number> out, std::uint64_t rows, std::uint64_t columns)
    : out_(out), columns_(columns), there_(rows, 0) {
  std::uint64_t entries = 0;
  if (__builtin_mul_overflow(rows, columns, &entries) || out.size() != entries)
    throw std::logic_error("MatrixInMemory: the array has " + std::to_string(out.size()) + " entries, not " +
                           std::to_string(rows) + " x " + std::to_string(columns));
}

template <>
void MatrixInMemory<double>::write(std::uint64_t row, std::span<const double> values) {
  require_row(row, there_.size(), values.size(), columns_);
  std::ranges::copy(values, out_.subspan(row * columns_, columns_).begin());
  there_[row] = 1;
}

template <>
void MatrixInMemory<float>::write(std::uint64_t row, std::span<const double> values) {
  require_row(row, there_.size(), values.size(), columns_);
  round_to_float32(values, out_.subspan(row * columns_, columns_), row, "the matrix");
  there_[row] = 1;
}

template <class Number>
bool MatrixInMemory<Number>::has(std::uint64_t row) const {
  return row < there_.size() && there_[row] != 0;
}

template <class Number>
void MatrixInMemory<Number>::finish() {
  require_all(there_);
}

template class MatrixInMemory<double>;
template class MatrixInMemory<float>;

RowStatistics::RowStatistics(std::uint64_t rows, std::uint64_t columns)
    : columns_(columns), rows_(rows), there_(rows, 0) {}

void RowStatistics::write(std::uint64_t row, std::span<const double> values) {
  require_row(row, there_.size(), values.size(), columns_);
  RowSummary summary;
  double sum = 0;  // in the order of the columns, so that it rounds alike in every run
  for (const double value : values) {
    if (std::isnan(value)) {
      ++summary.dropped;
    } else if (std::isinf(value)) {
      ++summary.unreachable;
    } else {
      ++summary.reached;
      summary.max = std::max(summary.max, value);
      sum += value;
    }
  }
  summary.mean = sum / static_cast<double>(summary.reached);  // 0 / 0 is NaN
  if (summary.reached == 0) summary.max = summary.mean;
  rows_[row] = summary;
  there_[row] = 1;
}

bool RowStatistics::has(std::uint64_t row) const { return row < there_.size() && there_[row] != 0; }

void RowStatistics::finish() { require_all(there_); }

}  // namespace geodrome
