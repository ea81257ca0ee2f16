// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace geodrome {

/// Takes the rows of a distance matrix as they are computed: rows = sources, columns = targets, both from 0, +inf for
/// unreachable or beyond the limit, NaN for a point that was dropped or is off the part. `MatrixFile` (matrix_file.hpp)
/// stores them on disk, `MatrixInMemory` in memory; `RowStatistics` keeps a summary of each.
///
/// Rows come in any order and from several threads, each at most once. What a sink keeps must not depend on that order:
/// it writes only what belongs to the row, and combines rows in `finish`, in ascending order. A sparse sink (CSR) would
/// keep the columns and values of each row apart and join them in `finish`; a sink of parcel means would keep one sum
/// and one count for each parcel of columns and row, and add up the rows of a parcel in `finish`.
class RowSink {
 public:
  virtual ~RowSink() = default;

  /// Takes one row. Thread-safe for different rows. Throws std::logic_error for a row or a number of values that the
  /// matrix does not have, and what the sink says.
  virtual void write(std::uint64_t row, std::span<const double> values) = 0;

  /// True for a row that need not be computed, because the sink has it already. Thread-safe, but for a row that is
  /// being written.
  virtual bool has(std::uint64_t row) const = 0;

  /// Completes the output. To be called once, from one thread, after the last row; a run that computes only some rows,
  /// or is interrupted, does not call it.
  virtual void finish() = 0;
};

/// Stores the rows in an array of the caller, row after row (C order). `Number`: double or float.
template <class Number>
class MatrixInMemory final : public RowSink {
 public:
  /// `out` must outlive the sink. Throws std::logic_error unless out.size() == rows * columns. O(rows).
  MatrixInMemory(std::span<Number> out, std::uint64_t rows, std::uint64_t columns);

  /// Throws OptionError for a finite distance that float would turn into infinity or 0; the row is then not there.
  void write(std::uint64_t row, std::span<const double> values) override;
  bool has(std::uint64_t row) const override;
  /// Throws std::logic_error if rows are missing.
  void finish() override;

 private:
  std::span<Number> out_;
  std::uint64_t columns_;
  std::vector<unsigned char> there_;  // a byte a row: threads write different rows at once
};

/// The counts of one row.
struct RowSummary {
  std::uint64_t reached = 0;      ///< columns at a finite distance, the source itself among them if it is a target
  std::uint64_t unreachable = 0;  ///< columns at +inf: in another component, or beyond the limit
  std::uint64_t dropped = 0;      ///< columns that are NaN
  double mean = 0;                ///< of the reached columns; NaN if there are none
  double max = 0;                 ///< the eccentricity of the source among the reached columns; NaN if there are none

  bool operator==(const RowSummary&) const = default;
};

/// Reduces each row to its summary, so that a matrix that no disk holds can still be measured. Memory: O(rows).
class RowStatistics final : public RowSink {
 public:
  /// O(rows).
  RowStatistics(std::uint64_t rows, std::uint64_t columns);

  /// O(columns).
  void write(std::uint64_t row, std::span<const double> values) override;
  bool has(std::uint64_t row) const override;
  /// Throws std::logic_error if rows are missing.
  void finish() override;

  /// Per row. Those that are not there are zeros.
  std::span<const RowSummary> rows() const noexcept { return rows_; }

 private:
  std::uint64_t columns_;
  std::vector<RowSummary> rows_;
  std::vector<unsigned char> there_;
};

}  // namespace geodrome
