// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>

namespace geodrome {

/// Standard output of a program that runs a plugin on somebody's behalf: it carries the answer alone, what the plugin
/// prints goes to standard error. Make it before the plugin is loaded.
class Answer {
 public:
  /// Ends the process with status 3 if there is no standard output or error.
  explicit Answer(const char* program) : descriptor_(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3)) {
    if (descriptor_ >= 0 && dup2(STDERR_FILENO, STDOUT_FILENO) >= 0) return;
    std::perror(program);
    _exit(3);
  }

  /// Writes the answer and ends the process at once, with status 3 if nobody reads it: no destructor of the plugin gets
  /// another chance to run.
  [[noreturn]] void end(std::string_view text, int status) const {
    while (!text.empty()) {
      const ssize_t count = write(descriptor_, text.data(), text.size());
      if (count <= 0) _exit(3);
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    _exit(status);
  }

 private:
  int descriptor_;
};

}  // namespace geodrome
