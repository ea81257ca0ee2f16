// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/row_sink.hpp"
#include "geodrome/engine/scalar_type.hpp"

namespace geodrome {

/// The sink that stores a distance matrix on disk: written row by row, in any order, from any thread, it survives the
/// end of the process at any moment.
///
/// While it grows it is one file, OUT.partial: a dense file (header, then rows; of .npy for text formats), then a
/// footer with the fingerprint of the run and a 64-bit checksum per row, which tells the rows that are whole. `finish`
/// cuts the footer off and renames the file (for text: writes the text, then removes the .partial); while it does, the
/// footer (the text) is in OUT.partial-footer (OUT.partial-text). Nothing else is left on disk.
class MatrixFile final : public RowSink {
 public:
  struct Spec {
    std::filesystem::path out;  ///< its ending tells the format: .npy or .csv
    std::uint64_t rows = 0, columns = 0;
    ScalarType scalar = ScalarType::float64;
    std::string fingerprint;  ///< text that two runs share exactly if their matrices are the same bytes
  };

  /// Size of the dense file, in bytes. Throws OptionError for an unknown ending, RefusedError if that is more than a
  /// file can hold.
  static std::uint64_t bytes(const Spec& spec);

  /// Starts OUT.partial, or with `resume` goes on with the one that is there. Throws OptionError for an unknown ending
  /// or a .csv of more than 1e6 entries, InputError (io) if it cannot be written, RefusedError if the disk has not
  /// enough room, or on `resume` if the fingerprint differs (saying in which part: the fingerprint is a JSON object,
  /// its members are compared) or the partial is damaged. A .partial that is there is overwritten without `resume`,
  /// unless another process is writing it: RefusedError. With `resume` and no .partial it starts anew. With `resume`
  /// every row on record is read and compared with its checksum: O(bytes); those that were damaged count as not there.
  static MatrixFile open(const Spec& spec, bool resume);

  MatrixFile(MatrixFile&&) noexcept;
  MatrixFile& operator=(MatrixFile&&) noexcept;
  ~MatrixFile() override;  ///< leaves the .partial where it is

  /// Thread-safe.
  bool has(std::uint64_t row) const override;
  std::uint64_t rows_done() const;
  /// False where the file system has no locks: then OUT.partial-lock keeps other processes away, which one that is
  /// killed leaves.
  bool is_locked() const;

  /// Writes one row; safe to call from several threads for different rows. Throws InputError (io), naming the file and
  /// the system's reason, e.g. when the disk is full; OptionError for a finite distance that float32 would turn into
  /// infinity or 0; std::logic_error for a row or a number of values that the matrix does not have.
  void write(std::uint64_t row, std::span<const double> values) override;

  /// Reads a row that is there back, as stored; works after `finish` too. Throws InputError (io) if it changed on disk,
  /// std::out_of_range if it is not there. Thread-safe.
  std::vector<double> read(std::uint64_t row) const;

  /// Precondition: every row is there (std::logic_error). Afterwards `spec.out` exists, whole and on the disk, and
  /// OUT.partial does not. Throws InputError (io) as `write`; then OUT.partial is still there.
  void finish() override;

 private:
  struct Impl;
  explicit MatrixFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace geodrome
