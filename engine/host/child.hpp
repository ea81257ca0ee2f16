// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace geodrome {

/// The end of a child process. Exactly one of `exited`, `signal` and `timed_out` is set.
struct ChildEnd {
  bool exited = false, timed_out = false;
  int status = 0, signal = 0;
  std::string out, err;  ///< what it wrote; the rest beyond 1 MiB each is dropped
};

/// Runs a program with its standard input empty and waits for its end, at most for `limit`; then it and what it
/// started is killed. Uses posix_spawn, which unlike fork is safe in a program with threads. Throws PluginError if the
/// program cannot be started, RefusedError if the machine has not enough for it. Thread-safe.
ChildEnd run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   std::chrono::milliseconds limit);

/// The last line that is not blank of what a process wrote to its standard error, in brackets for a message; empty if
/// there is none.
std::string last_words(const ChildEnd& end);

/// "SIGSEGV" for a child that a signal ended.
std::string signal_name(const ChildEnd& end);

}  // namespace geodrome
