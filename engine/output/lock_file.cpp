// SPDX-License-Identifier: MIT
#include "engine/output/lock_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

std::string process_and_machine() {
  char machine[256] = "";
  ::gethostname(machine, sizeof machine - 1);
  return "process " + std::to_string(::getpid()) + " on " + machine;
}

/// What the owner wrote, as far as it is there.
std::string owner_in(const std::filesystem::path& path) {
  char text[300];
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const ssize_t size = file < 0 ? 0 : ::read(file, text, sizeof text);
  if (file >= 0) ::close(file);
  return size > 0 ? std::string(text, static_cast<std::size_t>(size)) : "another process";
}

}  // namespace

LockFile::LockFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::string owner = process_and_machine();
  const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0 && errno == EEXIST)
    throw RefusedError(path_.string() + " is there: " + owner_in(path_) + " writes, or was killed",
                       "wait for it, remove the file if it is gone, or choose another output");
  if (file < 0)
    throw InputError(InputFault::io, "cannot write " + path_.string() + ": " + std::generic_category().message(errno),
                     "check the path, its permissions and the room on the disk");
  [[maybe_unused]] const ssize_t written = ::write(file, owner.data(), owner.size());  // the name is the lock
  ::close(file);
}

LockFile::~LockFile() { ::unlink(path_.c_str()); }

}  // namespace geodrome
