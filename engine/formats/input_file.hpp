// SPDX-License-Identifier: MIT
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace geodrome::input {

/// A file that is open for reading. Interrupted and short calls are carried on. A file that is replaced by another one
/// under its name goes on being read as it was; one whose content changes is found out by `demand_unchanged`. Every
/// member throws InputError (io) with the file's name and the system's words unless it says otherwise.
class InputFile {
 public:
  /// Throws also for what is neither a regular file nor a pipe: devices such as /dev/zero never end.
  explicit InputFile(std::filesystem::path path);
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&& other) noexcept;
  ~InputFile();

  const std::filesystem::path& path() const noexcept { return path_; }
  /// The size when it was opened, in bytes; 0 for a pipe.
  std::uint64_t size() const noexcept;

  /// Reads what comes next, at most `size` bytes. Returns how many; 0 at the end.
  std::size_t read(char* data, std::size_t size);
  /// Reads at a given place. Throws also if the file ends before `offset + size`.
  void read_at(std::uint64_t offset, char* data, std::size_t size) const;
  /// Throws if the file's size or time of change is another than when it was opened: then what was read may be a
  /// mixture of two contents. Sees no change within one tick of the system's clock for files (some milliseconds).
  void demand_unchanged() const;

 private:
  [[noreturn]] void reject(const std::string& what, const char* remedy) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  struct stat opened_ {};
};

}  // namespace geodrome::input
