// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace geodrome {

/// An open file that is read and written at given places. Interrupted and short calls are carried on. Reading and
/// writing are thread-safe. Every member throws InputError (io) with the file's name and the system's words unless it
/// says otherwise.
class PosixFile {
 public:
  /// Opens for reading and writing; creates the file if it is not there, empties it if `empty`.
  PosixFile(std::filesystem::path path, bool empty);
  PosixFile(PosixFile&& other) noexcept;
  PosixFile& operator=(PosixFile&& other) noexcept;
  ~PosixFile();

  const std::filesystem::path& path() const noexcept { return path_; }
  std::uint64_t size() const;
  /// Disk room that the file takes now, in bytes: less than `size` where it has holes.
  std::uint64_t allocated() const;

  void write_at(std::uint64_t offset, const void* data, std::size_t size) const;
  /// Throws also if the file ends before `offset + size`.
  void read_at(std::uint64_t offset, void* data, std::size_t size) const;
  void resize(std::uint64_t size) const;
  /// Waits until all that was written is on the disk.
  void sync() const;

  /// Allots disk blocks for the first `size` bytes, so that later writes there do not run out of room. False if there
  /// is not enough; true without effect where the file system cannot do it.
  bool reserve(std::uint64_t size) const;

  /// Takes the exclusive lock of the file, which lasts as long as this object. False if somebody else has it.
  bool try_lock() const;
  /// True if `path()` still names this very file (it may have been renamed or removed).
  bool is_at_its_path() const;

 private:
  [[noreturn]] void fail(const char* verb) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Removes a file if it is there. Throws InputError (io).
void remove_if_there(const std::filesystem::path& file);

/// Renames, replacing `to`, and waits until that is on the disk. Throws InputError (io).
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace geodrome
