// SPDX-License-Identifier: MIT
#include "engine/output/posix_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

[[noreturn]] void fail_io(const char* verb, const std::filesystem::path& path, const std::string& reason) {
  throw InputError(InputFault::io, std::string("cannot ") + verb + " " + path.string() + ": " + reason,
                   "check the path, its permissions and the room on the disk");
}

std::string system_words() { return std::generic_category().message(errno); }

/// Calls again while a signal interrupts.
template <class Call>
auto uninterrupted(Call call) {
  for (;;)
    if (const auto result = call(); result != -1 || errno != EINTR) return result;
}

// Linux moves at most 0x7ffff000 bytes a call; a round number below keeps every call valid.
constexpr std::size_t largest_transfer = std::size_t{1} << 30;

}  // namespace

PosixFile::PosixFile(std::filesystem::path path, bool empty) : path_(std::move(path)) {
  const int flags = O_RDWR | O_CREAT | O_CLOEXEC | (empty ? O_TRUNC : 0);
  descriptor_ = uninterrupted([&] { return ::open(path_.c_str(), flags, 0666); });
  if (descriptor_ == -1) fail("open");
}

PosixFile::PosixFile(PosixFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

PosixFile& PosixFile::operator=(PosixFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

PosixFile::~PosixFile() {
  if (descriptor_ != -1) ::close(descriptor_);
}

void PosixFile::fail(const char* verb) const { fail_io(verb, path_, system_words()); }

std::uint64_t PosixFile::size() const {
  struct stat status;
  if (::fstat(descriptor_, &status) != 0) fail("examine");
  return static_cast<std::uint64_t>(status.st_size);
}

std::uint64_t PosixFile::allocated() const {
  struct stat status;
  if (::fstat(descriptor_, &status) != 0) fail("examine");
  return static_cast<std::uint64_t>(status.st_blocks) * 512;  // POSIX leaves the unit open; Linux and BSD count in 512
}

void PosixFile::write_at(std::uint64_t offset, const void* data, std::size_t size) const {
  for (auto place = static_cast<const char*>(data); size > 0;) {
    const std::size_t part = std::min(size, largest_transfer);
    const ssize_t moved = uninterrupted([&] { return ::pwrite(descriptor_, place, part, static_cast<off_t>(offset)); });
    if (moved == -1) fail("write");
    place += moved, offset += static_cast<std::uint64_t>(moved), size -= static_cast<std::size_t>(moved);
  }
}

void PosixFile::read_at(std::uint64_t offset, void* data, std::size_t size) const {
  for (auto place = static_cast<char*>(data); size > 0;) {
    const std::size_t part = std::min(size, largest_transfer);
    const ssize_t moved = uninterrupted([&] { return ::pread(descriptor_, place, part, static_cast<off_t>(offset)); });
    if (moved == -1) fail("read");
    if (moved == 0) fail_io("read", path_, "the file ends too early");
    place += moved, offset += static_cast<std::uint64_t>(moved), size -= static_cast<std::size_t>(moved);
  }
}

void PosixFile::resize(std::uint64_t size) const {
  if (uninterrupted([&] { return ::ftruncate(descriptor_, static_cast<off_t>(size)); }) == -1) fail("resize");
}

void PosixFile::sync() const {
  if (uninterrupted([&] { return ::fsync(descriptor_); }) == -1) fail("write");
}

bool PosixFile::reserve(std::uint64_t size) const {
  if (size == 0) return true;
  // Not posix_fallocate: where the file system cannot do it, that writes into every block, which takes hours over a
  // network.
  if (uninterrupted([&] { return ::fallocate(descriptor_, 0, 0, static_cast<off_t>(size)); }) == 0) return true;
  if (errno == ENOSPC || errno == EDQUOT) return false;
  if (errno == EOPNOTSUPP || errno == ENOSYS) return true;
  fail("reserve room for");
}

bool PosixFile::try_lock() const {
  if (uninterrupted([&] { return ::flock(descriptor_, LOCK_EX | LOCK_NB); }) == 0) return true;
  if (errno == EWOULDBLOCK) return false;
  fail("lock");
}

bool PosixFile::is_at_its_path() const {
  struct stat here, there;
  if (::fstat(descriptor_, &here) != 0) fail("examine");
  return ::stat(path_.c_str(), &there) == 0 && here.st_dev == there.st_dev && here.st_ino == there.st_ino;
}

void remove_if_there(const std::filesystem::path& file) {
  if (::unlink(file.c_str()) != 0 && errno != ENOENT) fail_io("remove", file, system_words());
}

void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) fail_io("write", to, system_words());
  const std::filesystem::path folder = to.has_parent_path() ? to.parent_path() : ".";
  const int descriptor = uninterrupted([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
  if (descriptor == -1)
    return;  // a folder that may be written but not read cannot be synced; the file is whole all the same
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace geodrome
