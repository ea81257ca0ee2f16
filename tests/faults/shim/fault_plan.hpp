// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>

namespace geodrome::faults {

/// What GEODROME_FAULT says: "call=pwrite;path=/tmp/x;at=3;times=1;errno=28;short=-1;act=;log=FILE", all but `call`
/// optional.
///
/// The calls named `call` whose path contains `path` are counted from 1. From the one with the number `at` on, `times`
/// of them (0: all) fail with `errno`, or move `short` bytes at most if that is not -1, or are carried out after `act`:
///
///     truncate, grow, rewrite   does so to the file `path`, which is then a whole path
///     replace                   renames `path` + ".new" to `path`
///     signal:N                  sends itself the signal N
///
/// To `log` goes a byte for each call that counts, 'F' where the plan struck, else 'c' (of "malloc" only if `at` is 0:
/// they are many).
class FaultPlan {
 public:
  FaultPlan() {
    const char* text = std::getenv("GEODROME_FAULT");
    if (text == nullptr) return;
    std::snprintf(text_, sizeof text_, "%s", text);
    for (char *rest = text_, *part = nullptr; (part = strsep(&rest, ";")) != nullptr;) set(part);
    log_ = static_cast<int>(syscall(SYS_openat, AT_FDCWD, log_file_, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    unsetenv("LD_PRELOAD");  // for the children
    is_there_ = true;
  }

  void begin() { active_ = is_there_; }

  bool strikes(const char* call, const char* path) {
    if (!active_ || std::strcmp(call, call_) != 0 || std::strstr(path, path_) == nullptr) return false;
    const unsigned long number = ++counted_;
    const bool struck = at_ != 0 && number >= at_ && (times_ == 0 || number - at_ < times_);
    if (struck || at_ == 0 || *call != 'm') syscall(SYS_write, log_, struck ? "F" : "c", 1);
    return struck;
  }

  bool strikes(const char* call, int descriptor) {
    if (!active_ || std::strcmp(call, call_) != 0) return false;
    char link[64], path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const long length = syscall(SYS_readlinkat, AT_FDCWD, link, path, sizeof path - 1);
    path[length < 0 ? 0 : length] = '\0';
    return strikes(call, path);
  }

  /// After a strike: true if the call is to be carried out, since `act` was the fault, which is done here.
  bool goes_on() const {
    if (act_[0] == '\0') return false;
    if (std::strncmp(act_, "signal:", 7) == 0)
      ::kill(::getpid(), std::atoi(act_ + 7));
    else
      change_file();
    return true;
  }

  template <class Result>
  Result fail() const {
    errno = error;
    if constexpr (std::is_pointer_v<Result>)
      return nullptr;
    else
      return -1;
  }

  int error = EIO;
  long shortened = -1;

 private:
  void set(const char* part) {
    const char* equals = std::strchr(part, '=');
    if (equals == nullptr) return;
    const char* value = equals + 1;
    const auto is = [&](const char* name) { return std::strncmp(part, name, std::strlen(name)) == 0; };
    if (is("call=")) call_ = value;
    if (is("path=")) path_ = value;
    if (is("act=")) act_ = value;
    if (is("log=")) log_file_ = value;
    if (is("at=")) at_ = std::strtoul(value, nullptr, 10);
    if (is("times=")) times_ = std::strtoul(value, nullptr, 10);
    if (is("errno=")) error = std::atoi(value);
    if (is("short=")) shortened = std::atol(value);
  }

  void change_file() const {
    char fresh[4096];
    std::snprintf(fresh, sizeof fresh, "%s.new", path_);
    if (std::strcmp(act_, "replace") == 0) {
      syscall(SYS_rename, fresh, path_);
      return;
    }
    const long file = syscall(SYS_openat, AT_FDCWD, path_, O_RDWR | O_CLOEXEC, 0);
    const long size = syscall(SYS_lseek, file, 0L, SEEK_END);
    if (std::strcmp(act_, "truncate") == 0) syscall(SYS_ftruncate, file, size / 2);
    if (std::strcmp(act_, "grow") == 0) syscall(SYS_pwrite64, file, "\n0 0 0\n", 7L, size);
    if (std::strcmp(act_, "rewrite") == 0) syscall(SYS_pwrite64, file, "1 1 1", 5L, size / 2);
    syscall(SYS_close, file);
  }

  char text_[8192] = "";
  const char *call_ = "", *path_ = "", *act_ = "", *log_file_ = "/dev/null";
  unsigned long at_ = 0, times_ = 1;
  std::atomic<unsigned long> counted_ = 0;
  long log_ = -1;
  bool is_there_ = false, active_ = false;
};

inline FaultPlan faults_of_this_process;

/// Inactive until `begin`.
inline FaultPlan& plan() { return faults_of_this_process; }

}  // namespace geodrome::faults
