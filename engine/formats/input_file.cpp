// SPDX-License-Identifier: MIT
#include "engine/formats/input_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "geodrome/errors.hpp"

namespace geodrome::input {
namespace {

std::string last_reason() { return std::generic_category().message(errno); }

/// Linux moves at most 0x7ffff000 bytes a call; a round number below keeps every call valid.
constexpr std::size_t largest_read = std::size_t{1} << 30;

bool same_content(const struct stat& a, const struct stat& b) {
  return a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

}  // namespace

void InputFile::reject(const std::string& what, const char* remedy) const {
  throw InputError(InputFault::io, path_.string() + ": " + what, remedy);
}

InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)) {
  do descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  while (descriptor_ < 0 && errno == EINTR);
  if (descriptor_ < 0 && (errno == ENOENT || errno == ENOTDIR)) reject("there is no such file", "check the path");
  if (descriptor_ < 0) reject("cannot be opened: " + last_reason(), "check its permissions");
  try {
    if (::fstat(descriptor_, &opened_) != 0) reject("cannot be examined: " + last_reason(), "check the disk");
    if (S_ISDIR(opened_.st_mode)) reject("is a directory", "give a file inside it");
    if (!S_ISREG(opened_.st_mode) && !S_ISFIFO(opened_.st_mode)) reject("is no regular file", "");
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), opened_(other.opened_) {}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(opened_, other.opened_);
  return *this;
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::uint64_t InputFile::size() const noexcept {
  return S_ISREG(opened_.st_mode) ? static_cast<std::uint64_t>(opened_.st_size) : 0;
}

std::size_t InputFile::read(char* data, std::size_t size) {
  for (;;) {
    const ssize_t count = ::read(descriptor_, data, std::min(size, largest_read));
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) reject("cannot be read: " + last_reason(), "check the disk");
  }
}

void InputFile::read_at(std::uint64_t offset, char* data, std::size_t size) const {
  while (size > 0) {
    const ssize_t count = ::pread(descriptor_, data, std::min(size, largest_read), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) reject("cannot be read: " + last_reason(), "check the disk");
    if (count == 0) {
      demand_unchanged();
      reject("ends too early", "write it again");
    }
    data += count, offset += static_cast<std::uint64_t>(count), size -= static_cast<std::size_t>(count);
  }
}

void InputFile::demand_unchanged() const {
  if (!S_ISREG(opened_.st_mode)) return;
  struct stat now {};
  if (::fstat(descriptor_, &now) != 0) reject("cannot be examined: " + last_reason(), "check the disk");
  if (!same_content(opened_, now))
    reject("was changed while it was read",
           "run again once nobody writes it; to replace it, rename a whole file to it");
}

}  // namespace geodrome::input
