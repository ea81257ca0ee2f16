// SPDX-License-Identifier: MIT
#include "engine/output/partial_matrix.hpp"

#include <xxhash.h>

#include <optional>
#include <stdexcept>
#include <vector>

#include "engine/formats/remedies.hpp"
#include "engine/output/partial_footer.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace fs = std::filesystem;
namespace {

fs::path partial_of(const fs::path& out) { return fs::path(out) += ".partial"; }
/// From the cut of the footer to the renaming, fingerprint and checksums are in this file.
fs::path saved_footer_of(const fs::path& out) { return fs::path(out) += ".partial-footer"; }

[[noreturn]] void refuse_room(const fs::path& out, std::uint64_t needed, std::uint64_t available) {
  throw RefusedError(out.string() + " needs " + std::to_string(needed) + " bytes more on disk, of which " +
                         std::to_string(available) + " are available",
                     "make room, write elsewhere, ask for fewer sources or targets, or store float32");
}

std::uint64_t available_room(const fs::path& out) {
  std::error_code error;
  const fs::space_info room = fs::space(out.has_parent_path() ? out.parent_path() : ".", error);
  if (error)
    throw InputError(InputFault::io, "cannot write " + out.string() + ": " + error.message(), "check the path");
  return room.available;
}

/// Bytes that are still to be found on the disk, where the partial takes up `allocated` of them already.
std::uint64_t needed_room(const DenseLayout& layout, std::uint64_t allocated, std::uint64_t room_beside) {
  return (layout.end() > allocated ? layout.end() - allocated : 0) + room_beside;
}

/// Opens and locks the partial. Another process may rename it between the two, when it is no longer ours to write.
PosixFile open_locked(const fs::path& partial, std::unique_ptr<LockFile>& lock_file) {
  for (;;) {
    PosixFile file(partial, false);
    const PosixFile::Lock lock = file.try_lock();
    if (lock == PosixFile::Lock::held_by_another)
      throw RefusedError(partial.string() + " is being written by another run",
                         "wait for it, or choose another output");
    if (lock == PosixFile::Lock::unsupported && !lock_file)
      lock_file = std::make_unique<LockFile>(fs::path(partial) += "-lock");
    if (file.is_at_its_path()) return file;
  }
}

/// The longest of the names beside `out` must be possible, before anything is created.
void check_name(const fs::path& out) {
  std::error_code error;
  if (fs::status(saved_footer_of(out), error).type() == fs::file_type::none)
    throw InputError(InputFault::io, "cannot write " + saved_footer_of(out).string() + ": " + error.message(),
                     "choose another name");
}

PosixFile open_with_room(const fs::path& out, const DenseLayout& layout, std::uint64_t room_beside,
                         std::unique_ptr<LockFile>& lock_file) {
  check_name(out);
  const fs::path partial = partial_of(out);
  const std::uint64_t available = available_room(out);
  if (const std::uint64_t all = needed_room(layout, 0, room_beside); all > available && !file_exists(partial))
    refuse_room(out, all, available);  // before anything is created
  PosixFile file = open_locked(partial, lock_file);
  if (const std::uint64_t needed = needed_room(layout, file.allocated(), room_beside); needed > available)
    refuse_room(out, needed, available);
  return file;
}

/// Never 0, which stands for "not there"; depends on the row, so that one row is not taken for another.
std::uint64_t checksum_of(std::uint64_t row, const void* bytes, std::size_t size) {
  const std::uint64_t value = XXH3_64bits_withSeed(bytes, size, row);
  return value == 0 ? 1 : value;
}

}  // namespace

PartialMatrix::PartialMatrix(const MatrixFile::Spec& spec, const DenseFormat& format, std::uint64_t room_beside,
                             bool resume)
    : spec_(spec),
      layout_(layout_of(format, spec)),
      room_beside_(room_beside),
      file_(open_with_room(spec.out, layout_, room_beside, lock_file_)),
      checksums_(new std::atomic<std::uint64_t>[spec.rows] {}) {
  const fs::path saved_footer = saved_footer_of(spec_.out);
  std::optional<MatrixFile::Spec> stored;
  if (resume) {
    restore_footer(file_, format, saved_footer);
    refuse_if_without_footer();
    stored = read_footer(file_, format);
  }
  remove_file(saved_footer);
  if (stored) {
    adopt(*stored, format);
    return;
  }
  try {
    start();
  } catch (...) {
    std::error_code ignored;
    fs::remove(file_.path(), ignored);  // nothing of worth is in it
    throw;
  }
}

void PartialMatrix::start() {
  file_.resize(0);
  file_.resize(layout_.end());
  reserve();
  write_footer(file_, spec_, layout_);
  file_.write_at(0, layout_.header().data(), layout_.header().size());
}

/// Goes on with the partial of `stored`: a row counts as done if what is on the disk matches its checksum.
void PartialMatrix::adopt(const MatrixFile::Spec& stored, const DenseFormat& format) {
  if (const std::string text = differences(stored, spec_); !text.empty())
    throw RefusedError(file_.path().string() + " was started by a different run: " + text,
                       remedies::start_anew("restore the options"));
  spec_.fingerprint = stored.fingerprint;  // which may be spelled otherwise
  layout_ = layout_of(format, spec_);
  reserve();
  file_.write_at(0, layout_.header().data(), layout_.header().size());
  std::vector<std::uint64_t> claimed(spec_.rows);
  file_.read_at(layout_.checksum(0), claimed.data(), claimed.size() * sizeof(std::uint64_t));
  std::vector<char> bytes(layout_.row_bytes());
  for (std::uint64_t row = 0; row < spec_.rows; ++row) {
    if (claimed[row] == 0) continue;
    file_.read_at(layout_.row(row), bytes.data(), bytes.size());
    if (checksum_of(row, bytes.data(), bytes.size()) != claimed[row]) continue;
    checksums_[row] = claimed[row];
    ++done_;
  }
}

void PartialMatrix::reserve() const {
  if (!file_.reserve(layout_.end()))
    refuse_room(spec_.out, needed_room(layout_, file_.allocated(), room_beside_), available_room(spec_.out));
}

/// A partial that is exactly the finished file and has no saved footer: nothing tells which run it is of.
void PartialMatrix::refuse_if_without_footer() const {
  std::string begin(layout_.header().size(), '\0');
  if (file_.size() != layout_.footer()) return;
  file_.read_at(0, begin.data(), begin.size());
  if (begin == layout_.header())
    throw RefusedError(file_.path().string() + " is a whole matrix, but nothing tells which run it is of",
                       remedies::start_anew("rename it to " + spec_.out.string() + " if you know"));
}

void PartialMatrix::write(std::uint64_t row, const void* bytes) {
  // The data first: a row whose checksum is on record is whole, or found out on resume.
  file_.write_at(layout_.row(row), bytes, layout_.row_bytes());
  const std::uint64_t checksum = checksum_of(row, bytes, layout_.row_bytes());
  file_.write_at(layout_.checksum(row), &checksum, sizeof(checksum));
  if (checksums_[row].exchange(checksum) == 0) ++done_;
}

void PartialMatrix::read(std::uint64_t row, void* bytes) const {
  if (!has(row)) throw std::out_of_range("matrix row " + std::to_string(row) + " is not there");
  file_.read_at(layout_.row(row), bytes, layout_.row_bytes());
  if (checksum_of(row, bytes, layout_.row_bytes()) != checksums_[row])
    throw InputError(InputFault::io, file_.path().string() + ": row " + std::to_string(row) + " changed on disk",
                     remedies::go_on_after_repair());
}

/// The name is given last, so that OUT is whole whenever it is there.
void PartialMatrix::publish() const {
  if (!file_.is_at_its_path())
    throw InputError(InputFault::io, file_.path().string() + " was removed or replaced while it was written",
                     "let one run at a time write it");
  const fs::path saved_footer = saved_footer_of(spec_.out);
  save_footer(file_, layout_, saved_footer);
  file_.resize(layout_.footer());
  sync();
  rename_durably(file_.path(), spec_.out);
  std::error_code ignored;
  fs::remove(saved_footer, ignored);
}

void PartialMatrix::remove() const { remove_file(file_.path()); }

}  // namespace geodrome
