// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace geodrome {

/// A file that says "somebody is at it" as long as this object lives: what a lock is where the file system has none. A
/// process that is killed leaves it.
class LockFile {
 public:
  /// Throws RefusedError, with process and machine, if there is such a file already; InputError (io) if it cannot be
  /// made.
  explicit LockFile(std::filesystem::path path);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

 private:
  const std::filesystem::path path_;
};

}  // namespace geodrome
