// SPDX-License-Identifier: MIT
#include "engine/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

// A file that is removed unless it was published under its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target)
      : target_(target), path_(target.string() + "." + std::to_string(::getpid()) + ".tmp") {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail();
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
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  // Some file systems tell of a full disk only when the file is closed.
  void publish() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail();
    if (::rename(path_.c_str(), target_.c_str()) != 0) fail();
    published_ = true;
  }

 private:
  [[noreturn]] void fail() const {
    const std::string reason = std::generic_category().message(errno);
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
  const auto status = std::filesystem::status(file, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError(InputFault::io, file.string() + ": cannot be written: is no regular file");
  TemporaryFile temporary(file);
  temporary.write(bytes);
  temporary.publish();
}

}  // namespace geodrome
