// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "engine/output/dense_layout.hpp"
#include "engine/output/lock_file.hpp"
#include "engine/output/posix_file.hpp"
#include "geodrome/engine/matrix_file.hpp"

namespace geodrome {

/// The file OUT.partial in which a matrix grows: a dense file of some format, then a footer with the fingerprint of the
/// run and a checksum per row (partial_footer.hpp). It is locked as long as this object lives; where the file
/// system has no locks, by the file OUT.partial-lock. Thread-safe for different rows.
class PartialMatrix {
 public:
  /// As `MatrixFile::open`. `room_beside`: bytes that will be needed on the same disk beside this file.
  PartialMatrix(const MatrixFile::Spec& spec, const DenseFormat& format, std::uint64_t room_beside, bool resume);

  const MatrixFile::Spec& spec() const noexcept { return spec_; }
  bool has(std::uint64_t row) const noexcept { return row < spec_.rows && checksums_[row] != 0; }
  std::uint64_t rows_done() const noexcept { return done_; }
  bool is_locked() const noexcept { return !lock_file_; }

  /// Writes a row, as its bytes are to stand in the file. Precondition: row < spec().rows, and there are as many bytes
  /// as a row has.
  void write(std::uint64_t row, const void* bytes);
  /// Reads the bytes of a row; works after `publish` too. Throws InputError (io) if they changed on disk,
  /// std::out_of_range if the row is not there.
  void read(std::uint64_t row, void* bytes) const;

  /// Waits until all is on the disk.
  void sync() const { file_.sync(); }
  /// Makes the file the finished dense file: without the footer, under the name `spec().out`, on the disk.
  /// Precondition: every row is there.
  void publish() const;
  /// Removes the file, whose rows were written elsewhere.
  void remove() const;

 private:
  void start();
  void adopt(const MatrixFile::Spec& stored, const DenseFormat& format);
  void refuse_if_without_footer() const;
  void reserve() const;

  MatrixFile::Spec spec_;
  DenseLayout layout_;
  std::uint64_t room_beside_;
  std::unique_ptr<LockFile> lock_file_;
  PosixFile file_;
  std::unique_ptr<std::atomic<std::uint64_t>[]> checksums_;  // per row; 0: not there
  std::atomic<std::uint64_t> done_ = 0;
};

}  // namespace geodrome
