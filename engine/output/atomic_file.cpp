// SPDX-License-Identifier: MIT
#include "engine/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "engine/output/posix_file.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

// A file that is removed unless it was published under its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) : target_(target) {
    // A name that is free: that of a run that was killed may stay, and on a shared disk another machine has such a
    // process too.
    for (int i = 0; descriptor_ < 0; ++i) {
      path_ = target.string() + "." + std::to_string(::getpid()) + "-" + std::to_string(i) + ".tmp";
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST && errno != EINTR) fail();
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!published_) ::unlink(path_.c_str());
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      if (count == 0) fail("the system takes no more bytes");
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  // A full or broken disk may be told only when the bytes are sent there, or when the file is closed.
  void publish() {
    while (::fsync(descriptor_) != 0)
      if (errno != EINTR) fail();
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0) fail();
    if (::rename(path_.c_str(), target_.c_str()) != 0) fail();
    published_ = true;
    sync_folder_of(target_);
  }

 private:
  [[noreturn]] void fail() const { fail(std::generic_category().message(errno)); }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(InputFault::io, target_.string() + ": cannot be written: " + reason,
                     "check the path, its permissions and the room on the disk");
  }

  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool published_ = false;
};

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
  // Renaming would replace a device such as /dev/stdout by a file.
  std::error_code ignored;
  if (file_exists(file) && !std::filesystem::is_regular_file(file, ignored))
    throw InputError(InputFault::io, file.string() + ": cannot be written: is no regular file");
  TemporaryFile temporary(file);
  temporary.write(bytes);
  temporary.publish();
}

}  // namespace geodrome
