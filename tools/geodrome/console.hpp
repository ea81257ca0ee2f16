// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "geodrome/engine/observer.hpp"

namespace geodrome::cli {

/// Tells a person at a terminal what goes on, on standard error: messages always, progress only on a terminal and only
/// for what takes over a second. Ctrl-C asks the job to stop; a second one ends the program at once.
class Console final : public Observer {
 public:
  explicit Console(bool quiet);
  ~Console() override;

  void progress(std::string_view stage, double fraction) override;
  void log(LogLevel level, std::string_view message) override;
  std::string words(const Remedy& remedy) const override;
  bool cancelled() const noexcept override;

 private:
  void clear_line();

  const bool quiet_, terminal_;
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point stage_began_, last_shown_;
  bool line_shown_ = false;
};

/// What a job gives. The console is gone when it returns, and with it the line of progress, so that results can be
/// printed on the same terminal.
template <class Job>
auto with_console(bool quiet, Job&& job) {
  Console console(quiet);
  return job(console);
}

/// The exit status of a job that broke the promises, 0 if there is none; says on standard error what not to trust.
int tell_broken_promises(const std::vector<std::string>& promises, const std::string& solver);

}  // namespace geodrome::cli
